#include "controller_setup.hpp"

#include "library_models.hpp"
#include "library_numbers.hpp"
#include "settings/constants.hpp"
#include "settings/joints.hpp"

#include <twiddle/icub_right_hand.h>
#include <twiddle/input_map.h>

#include <array>
#include <stdexcept>
#include <string>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

namespace
{

static_assert(static_cast<std::size_t>(TWD_ICUB_FEI) == fei && static_cast<std::size_t>(TWD_ICUB_AAI) == aai &&
                  static_cast<std::size_t>(TWD_ICUB_FET) == fet && static_cast<std::size_t>(TWD_ICUB_OT) == ot,
              "the harness and the controller share one order of joints");

// A setting as a number of the library.
constexpr auto num = twd_num_from_double;
constexpr auto wide = twd_wide_from_double;
constexpr auto rate = twd_rate_from_double;
constexpr auto small = twd_small_from_double;

// Throws std::runtime_error with `what` and the library's sentence if `error` is one.
void require(twd_error error, const std::string &what)
{
    if (error != TWD_OK) throw std::runtime_error("the controller refuses " + what + ": " + twd_error_text(error));
}

twd_joint joint(std::size_t index, const settings::Setup &setup)
{
    const settings::HandSetup &hand = setup.hand;
    twd_joint joint{};
    joint.range = twd_icub_joint_range[index];
    joint.pd.stiffness_nm_per_rad = num(hand.stiffness_nm_per_rad[index]);
    joint.pd.damping_nms_per_rad = num(hand.damping_nms_per_rad[index]);
    joint.pd.torque_limit_nm = num(hand.torque_limit_nm);
    if (hand.pd_law == settings::PdLaw::stable) {
        const double period_s = control_step_s / setup.physics.substeps;
        require(twd_pd_stable(&joint.pd, small(hand.pd_inertia_kg_m2[index]), small(period_s), &joint.pd),
                "the set-up's gains or inertias");
    }
    return joint;
}

// A finger whose first two joints are `first` and `second` and whose others are held at `distal_deg`.
twd_finger finger(const twd_chain &chain, std::size_t first, std::size_t second, double distal_deg,
                  const settings::PhysicsSetup &physics)
{
    constexpr std::uint8_t moving = 2;
    twd_finger finger{};
    finger.joint[0] = static_cast<std::uint8_t>(first);
    finger.joint[1] = static_cast<std::uint8_t>(second);
    std::array<twd_num, TWD_MAX_CHAIN_JOINTS> held_rad{};
    held_rad.fill(num(distal_deg * rad_per_deg));
    const std::array<twd_num, 3> direction = {num(physics.gravity_direction[0]), num(physics.gravity_direction[1]),
                                              num(physics.gravity_direction[2])};
    require(twd_gravity_init(&finger.gravity, &chain, moving, held_rad.data(), wide(physics.gravity_m_s2),
                             direction.data()),
            "the set-up's gravity or held angles");
    return finger;
}

twd_cpg_config cpg_config(const settings::OscillatorSetup &setup, bool with_centre)
{
    twd_cpg_config config{};
    config.with_centre = with_centre;
    config.tick_s = small(control_step_s);
    config.amplitude_rate_per_s = rate(setup.amplitude_rate_per_s);
    config.centre_rate_per_s = rate(setup.centre_rate_per_s);
    if (setup.return_lag == settings::ReturnLag::equal) config.return_lag = TWD_RETURN_LAG_EQUAL;
    if (setup.centre_start == settings::CentreStart::zero) config.centre_start = TWD_CENTRE_START_AT_ZERO;
    if (setup.centre_start == settings::CentreStart::target) config.centre_start = TWD_CENTRE_START_AT_TARGET;
    return config;
}

} // namespace

twd_controller_config controller_config(const ControllerSetup &controller)
{
    const settings::Setup &setup = controller.setup;
    const settings::OscillatorSetup &oscillators = setup.oscillators;
    twd_controller_config config{};
    config.model = &find_model(controller.model);
    config.oscillators = cpg_config(oscillators, controller.with_centre);
    config.phase_start =
        oscillators.phase_start == settings::PhaseStart::zero ? TWD_PHASE_START_AT_ZERO : TWD_PHASE_START_AT_LAG;
    config.saturation = oscillators.saturation == settings::Saturation::each ? TWD_SATURATE_EACH : TWD_SATURATE_SUM;
    config.ranges.frequency_lower_hz = num(oscillators.frequency_lower_hz);
    config.ranges.frequency_upper_hz = num(oscillators.frequency_upper_hz);
    config.ranges.lone_frequency_hz = num(oscillators.lone_frequency_hz);
    config.ranges.amplitude_upper = num(oscillators.amplitude_upper);
    config.ranges.centre_lower = num(oscillators.centre_lower);
    config.ranges.centre_upper = num(oscillators.centre_upper);
    config.joints = joint_count;
    for (std::size_t i = 0; i < joint_count; ++i) {
        config.joint[i] = joint(i, setup);
    }
    config.fingers = 2;
    config.finger[0] = finger(twd_icub_index, aai, fei, setup.hand.index_distal_deg, setup.physics);
    config.finger[1] = finger(twd_icub_thumb, ot, fet, setup.hand.thumb_distal_deg, setup.physics);
    return config;
}

twd_learner_config learner_config(const AgentSetup &agent)
{
    const settings::LearnerSetup &setup = agent.controller.setup.learner;
    const twd_model &model = find_model(agent.controller.model);
    twd_learner_config config{};
    config.units = twd_model_parameters(&model, agent.controller.with_centre);
    config.inputs = TWD_INPUTS;
    config.actor_rate = num(setup.actor_rate);
    config.critic_rate = num(setup.critic_rate);
    config.weight_range = num(setup.weight_range);
    config.clip = num(setup.clip);
    config.noise.start = num(setup.noise_start);
    config.noise.end = num(setup.noise_end);
    config.noise.decay_fraction = num(setup.noise_decay_fraction);
    config.noise.trials = agent.trials;
    if (setup.selector_noise == settings::SelectorNoise::none) config.silent_units = model.cpgs > 1 ? model.cpgs : 0;
    config.learned_value =
        setup.learned_value == settings::LearnedValue::unclipped ? TWD_LEARN_FROM_UNCLIPPED : TWD_LEARN_FROM_CLIPPED;
    config.seed = agent.seed;
    return config;
}

LearnerInput learner_input(const sim::ObjectSpec &object, const settings::LearnerSetup &setup)
{
    twd_shape shape = TWD_SHAPE_SPHERE;
    if (object.shape == sim::Shape::cylinder) shape = TWD_SHAPE_CYLINDER;
    if (object.shape == sim::Shape::cube) shape = TWD_SHAPE_CUBE;
    std::array<twd_num, TWD_INPUTS> responses{};
    twd_input_map(shape, num(object.size_m), wide(setup.input_squared_norm), responses.data());
    return doubles_of(responses.data(), responses.size(), twd_num_to_double);
}

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
