#include "controller_setup.hpp"

#include "sim/joints.hpp"

#include <twiddle/icub_right_hand.h>

#include <stdexcept>
#include <string>

namespace twiddle::experiment
{

namespace
{

static_assert(static_cast<std::size_t>(TWD_ICUB_FEI) == sim::fei &&
                  static_cast<std::size_t>(TWD_ICUB_AAI) == sim::aai &&
                  static_cast<std::size_t>(TWD_ICUB_FET) == sim::fet &&
                  static_cast<std::size_t>(TWD_ICUB_OT) == sim::ot,
              "the harness and the controller share one order of joints");

constexpr double rad_per_deg = 3.14159265358979323846 / 180;

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

twd_joint joint(std::size_t index, const sim::Setup &setup)
{
    const sim::HandSetup &hand = setup.hand;
    twd_joint joint{};
    joint.range = twd_icub_joint_range[index];
    joint.pd.stiffness_nm_per_rad = num(hand.stiffness_nm_per_rad[index]);
    joint.pd.damping_nms_per_rad = num(hand.damping_nms_per_rad[index]);
    joint.pd.torque_limit_nm = num(hand.torque_limit_nm);
    if (hand.pd_law == sim::PdLaw::stable) {
        const double period_s = control_step_s / setup.physics.substeps;
        require(twd_pd_stable(&joint.pd, small(hand.pd_inertia_kg_m2[index]), small(period_s), &joint.pd),
                "the set-up's gains or inertias");
    }
    return joint;
}

// A finger whose first two joints are `first` and `second` and whose others are held at `distal_deg`.
twd_finger finger(const twd_chain &chain, std::size_t first, std::size_t second, double distal_deg,
                  const sim::PhysicsSetup &physics)
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

twd_cpg_config cpg_config(const sim::OscillatorSetup &setup, bool with_centre)
{
    twd_cpg_config config{};
    config.with_centre = with_centre;
    config.tick_s = small(control_step_s);
    config.amplitude_rate_per_s = rate(setup.amplitude_rate_per_s);
    config.centre_rate_per_s = rate(setup.centre_rate_per_s);
    if (setup.return_lag == sim::ReturnLag::equal) config.return_lag = TWD_RETURN_LAG_EQUAL;
    if (setup.centre_start == sim::CentreStart::zero) config.centre_start = TWD_CENTRE_START_AT_ZERO;
    if (setup.centre_start == sim::CentreStart::target) config.centre_start = TWD_CENTRE_START_AT_TARGET;
    return config;
}

} // namespace

twd_controller_config controller_config(const sim::Setup &setup, const twd_model &model, bool with_centre)
{
    const sim::OscillatorSetup &oscillators = setup.oscillators;
    twd_controller_config config{};
    config.model = &model;
    config.oscillators = cpg_config(oscillators, with_centre);
    config.phase_start =
        oscillators.phase_start == sim::PhaseStart::zero ? TWD_PHASE_START_AT_ZERO : TWD_PHASE_START_AT_LAG;
    config.saturation = oscillators.saturation == sim::Saturation::each ? TWD_SATURATE_EACH : TWD_SATURATE_SUM;
    config.ranges.frequency_lower_hz = num(oscillators.frequency_lower_hz);
    config.ranges.frequency_upper_hz = num(oscillators.frequency_upper_hz);
    config.ranges.lone_frequency_hz = num(oscillators.lone_frequency_hz);
    config.ranges.amplitude_upper = num(oscillators.amplitude_upper);
    config.ranges.centre_lower = num(oscillators.centre_lower);
    config.ranges.centre_upper = num(oscillators.centre_upper);
    config.joints = sim::joint_count;
    for (std::size_t i = 0; i < sim::joint_count; ++i) {
        config.joint[i] = joint(i, setup);
    }
    config.fingers = 2;
    config.finger[0] = finger(twd_icub_index, sim::aai, sim::fei, setup.hand.index_distal_deg, setup.physics);
    config.finger[1] = finger(twd_icub_thumb, sim::ot, sim::fet, setup.hand.thumb_distal_deg, setup.physics);
    return config;
}

twd_learner_config learner_config(const sim::LearnerSetup &setup, const twd_model &model, bool with_centre,
                                  std::uint32_t trials, std::uint64_t seed)
{
    twd_learner_config config{};
    config.units = twd_model_parameters(&model, with_centre);
    config.inputs = TWD_INPUTS;
    config.actor_rate = num(setup.actor_rate);
    config.critic_rate = num(setup.critic_rate);
    config.weight_range = num(setup.weight_range);
    config.clip = num(setup.clip);
    config.noise.start = num(setup.noise_start);
    config.noise.end = num(setup.noise_end);
    config.noise.decay_fraction = num(setup.noise_decay_fraction);
    config.noise.trials = trials;
    if (setup.selector_noise == sim::SelectorNoise::none) config.silent_units = model.cpgs > 1 ? model.cpgs : 0;
    config.learned_value =
        setup.learned_value == sim::LearnedValue::unclipped ? TWD_LEARN_FROM_UNCLIPPED : TWD_LEARN_FROM_CLIPPED;
    config.seed = seed;
    return config;
}

LearnerInput learner_input(const sim::ObjectSpec &object, const sim::LearnerSetup &setup)
{
    twd_shape shape = TWD_SHAPE_SPHERE;
    if (object.shape == sim::Shape::cylinder) shape = TWD_SHAPE_CYLINDER;
    if (object.shape == sim::Shape::cube) shape = TWD_SHAPE_CUBE;
    LearnerInput input{};
    twd_input_map(shape, num(object.size_m), wide(setup.input_squared_norm), input.data());
    return input;
}

} // namespace twiddle::experiment
