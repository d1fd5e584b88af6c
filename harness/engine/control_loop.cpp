#include "control_loop.hpp"

#include <twiddle/convert.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

namespace
{

using JointNumbers = std::array<twd_num, TWD_MAX_JOINTS>;
using JointRates = std::array<twd_rate, TWD_MAX_JOINTS>;

static_assert(joint_count <= TWD_MAX_JOINTS, "the library is built for fewer joints than the hand has");

JointVector joint_vector(const JointNumbers &numbers)
{
    JointVector vector{};
    for (std::size_t i = 0; i < joint_count; ++i) {
        vector[i] = twd_num_to_double(numbers[i]);
    }
    return vector;
}

} // namespace

ControlLoop::ControlLoop(const ControllerSetup &setup)
{
    const twd_controller_config config = controller_config(setup);
    const twd_error error = twd_controller_init(&controller_, &config);
    if (error != TWD_OK)
        throw std::runtime_error("the controller refuses set-up '" + setup.setup.name + "': " + twd_error_text(error));
}

void ControlLoop::start(const Parameters &parameters)
{
    std::vector<twd_num> numbers;
    std::transform(parameters.begin(), parameters.end(), std::back_inserter(numbers), twd_num_from_double);
    start_with(numbers);
}

void ControlLoop::start_with(const std::vector<twd_num> &parameters)
{
    const twd_error error = twd_controller_start(&controller_, parameters.data(), parameters.size());
    if (error != TWD_OK)
        throw std::invalid_argument(std::string("the controller refuses the parameters: ") + twd_error_text(error));
}

JointCommands ControlLoop::torque(const JointReadings &readings, bool tick)
{
    JointNumbers angle_rad{};
    JointRates velocity_rad_s{};
    JointNumbers torque_nm{};
    for (std::size_t i = 0; i < joint_count; ++i) {
        angle_rad[i] = twd_num_from_double(readings.angle_rad[i]);
        velocity_rad_s[i] = twd_rate_from_double(readings.velocity_rad_s[i]);
    }
    if (tick) twd_controller_tick(&controller_, desired_rad_.data());
    twd_controller_torque(&controller_, desired_rad_.data(), angle_rad.data(), velocity_rad_s.data(), torque_nm.data());
    return {joint_vector(desired_rad_), joint_vector(torque_nm)};
}

ExpertWeights ControlLoop::weights() const
{
    return expert_weights(*controller_.config.model, controller_.weight);
}

ExpertWeights expert_weights(const twd_model &model, const twd_num *weight)
{
    static constexpr std::array<const twd_topology *, expert_count> experts = {&twd_cpg_c, &twd_cpg_m, &twd_cpg_s};
    ExpertWeights weights{};
    for (int k = 0; k < model.cpgs; ++k) {
        for (std::size_t expert = 0; expert < expert_count; ++expert) {
            if (model.topology[k] == experts[expert]) weights[expert] = twd_num_to_double(weight[k]);
        }
    }
    return weights;
}

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
