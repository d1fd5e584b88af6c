#include "one_build.hpp"

#include <twiddle/controller.h>
#include <twiddle/convert.h>
#include <twiddle/input_map.h>
#include <twiddle/learner.h>

#include <stdexcept>

inline namespace TWD_BUILD_NAMESPACE
{

// One name for three types: each build's has members of its own.
class Hand
{
  public:
    Hand()
    {
        twd_controller_config config = {};
        config.model = &twd_model_c;
        config.oscillators.with_centre = true;
        config.oscillators.tick_s = TWD_SMALL(0.01);
        config.oscillators.amplitude_rate_per_s = TWD_RATE(20);
        config.oscillators.centre_rate_per_s = TWD_RATE(20);
        config.ranges.frequency_lower_hz = TWD_NUM(0.5);
        config.ranges.frequency_upper_hz = TWD_NUM(1.5);
        config.ranges.lone_frequency_hz = TWD_NUM(1);
        config.ranges.amplitude_upper = TWD_NUM(0.5);
        config.ranges.centre_upper = TWD_NUM(1);
        config.joints = joints;
        for (int j = 0; j < joints; ++j) {
            config.joint[j].range.lower_rad = TWD_NUM(-0.5);
            config.joint[j].range.upper_rad = TWD_NUM(1);
            config.joint[j].pd.stiffness_nm_per_rad = TWD_NUM(0.5);
            config.joint[j].pd.torque_limit_nm = TWD_NUM(1);
        }
        require(twd_controller_init(&controller_, &config));
    }

    // Move for a second. The reward is where the first joint is wanted at the end.
    twd_wide try_out(const std::vector<twd_num> &parameters, Outcome &outcome)
    {
        const twd_num angle_rad[joints] = {};
        const twd_rate velocity_rad_s[joints] = {};
        twd_num desired_rad[joints] = {};
        twd_num torque_nm[joints] = {};
        require(twd_controller_start(&controller_, parameters.data(), parameters.size()));
        for (int tick = 0; tick < 100; ++tick) {
            twd_controller_tick(&controller_, desired_rad);
            twd_controller_torque(&controller_, desired_rad, angle_rad, velocity_rad_s, torque_nm);
            for (int j = 0; j < joints; ++j) {
                outcome.desired_rad.push_back(twd_num_to_double(desired_rad[j]));
                outcome.torques_nm.push_back(twd_num_to_double(torque_nm[j]));
            }
        }
        return twd_wide_of_num(desired_rad[0]);
    }

    static void require(twd_error error)
    {
        if (error != TWD_OK) throw std::runtime_error(twd_error_text(error));
    }

  private:
    static constexpr int joints = 4;
    twd_controller controller_;
};

Outcome run()
{
    twd_learner_config config = {};
    config.units = twd_model_parameters(&twd_model_c, true);
    config.inputs = TWD_INPUTS;
    config.actor_rate = TWD_NUM(0.1);
    config.critic_rate = TWD_NUM(0.1);
    config.weight_range = TWD_NUM(0.1);
    config.noise = {TWD_NUM(0.5), TWD_NUM(0.05), TWD_NUM(0.6), 3};
    config.seed = 7;
    twd_learner learner;
    Hand::require(twd_learner_init(&learner, &config));

    std::vector<twd_num> input(TWD_INPUTS);
    twd_input_map(TWD_SHAPE_CUBE, TWD_NUM(0.03), TWD_WIDE(5), input.data());
    std::vector<twd_num> parameters(config.units);
    Hand hand;
    Outcome outcome;
    for (int trial = 0; trial < 3; ++trial) {
        twd_learner_act(&learner, input.data(), parameters.data());
        for (const twd_num parameter : parameters) {
            outcome.parameters.push_back(twd_num_to_double(parameter));
        }
        const twd_wide reward = hand.try_out(parameters, outcome);
        twd_learner_learn(&learner, reward);
        outcome.reward += twd_wide_to_double(reward);
    }
    return outcome;
}

} // namespace TWD_BUILD_NAMESPACE

Outcome TWD_BUILD_NAME(run)()
{
    return run();
}
