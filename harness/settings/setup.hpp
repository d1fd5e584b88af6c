// setup.hpp: a physical and learning set-up, every choice that the paper leaves open, as plain named settings.
//
// Files: experiments/setups/common.toml holds every setting with its default and reason; NAME.toml beside it overrides
// some.
// The merged settings travel as a text (run.json), from which a Setup is read the same way.
#pragma once

#include "joints.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace twiddle::settings
{

enum class CubeSize { whole_diagonal, half_diagonal };
enum class PhaseStart { desired_lag, zero };
enum class ReturnLag { negated, equal };
enum class CentreStart { hand, zero, target };
enum class Saturation { sum, each };
enum class SelectorNoise { as_experts, none };
enum class LearnedValue { clipped, unclipped };
enum class PdLaw { plain, stable };

// [object]: what is turned, and where.
struct ObjectSetup {
    double hinge_x_m = 0; // palm frame
    double hinge_y_m = 0;
    double centre_z_m = 0;
    double mass_kg = 0;
    double cylinder_height_m = 0;                  // overrides the URDF's
    CubeSize cube_size = CubeSize::whole_diagonal; // reading of the paper's "base diagonal size"
    double rounding_m = 0;                         // radius of the rounded edges of cube and cylinder
    double coulomb_nm = 0;                         // hinge friction, Coulomb
    double viscous_nms_per_rad = 0;                // hinge friction, viscous
    int counted_direction = 1;                     // +1: counter-clockwise about palm +z is positive; -1: clockwise
};

// [hand]: what holds it and drives it.
struct HandSetup {
    double index_distal_deg = 0;  // index_2 = index_3
    double thumb_distal_deg = 0;  // thumb_2 = thumb_3
    double other_fingers_deg = 0; // all joints of middle, ring and little
    double reflected_inertia_kg_m2 = 0;
    double torque_limit_nm = 0;
    JointVector stiffness_nm_per_rad{};
    JointVector damping_nms_per_rad{};
    PdLaw pd_law = PdLaw::plain;
    JointVector pd_inertia_kg_m2{}; // what the stable law takes each joint's effective inertia for
};

// [contact] and [physics]: what both steppers solve, and how closely the reference does.
struct PhysicsSetup {
    double friction = 0;              // Coulomb coefficient between fingers and object
    bool index_thumb_contact = false; // whether the two fingers may touch each other
    double breaking_threshold_m = 0;  // contacts are made from this distance on
    int substeps = 0;                 // of one 10 ms control step
    int solver_iterations = 0;        // of the reference stepper, at most
    double solver_residual = 0;       // squared, at which the reference stepper's iterations end
    double error_reduction = 0;       // share of a penetration that is corrected in a substep
    double gravity_m_s2 = 0;
    std::array<double, 3> gravity_direction{}; // unit vector in the `hand` frame
};

// [oscillators]: the table of parameter ranges and the filters.
struct OscillatorSetup {
    double frequency_lower_hz = 0;
    double frequency_upper_hz = 0;
    double lone_frequency_hz = 0;
    double amplitude_upper = 0;
    double centre_lower = 0;
    double centre_upper = 0;
    double amplitude_rate_per_s = 0; // a
    double centre_rate_per_s = 0;    // b
    PhaseStart phase_start = PhaseStart::desired_lag;
    CentreStart centre_start = CentreStart::hand;
    ReturnLag return_lag = ReturnLag::negated; // phi_ji, of phi_ij
    Saturation saturation = Saturation::sum;   // of joint outputs to their ranges: before or after the CPGs are mixed
};

// [learner]
struct LearnerSetup {
    double actor_rate = 0;
    double critic_rate = 0;
    double input_squared_norm = 0;
    double weight_range = 0;
    double clip = 0;
    LearnedValue learned_value = LearnedValue::clipped; // of an explored output that the clip has changed
    SelectorNoise selector_noise = SelectorNoise::as_experts;
    double noise_start = 0;
    double noise_end = 0;
    double noise_decay_fraction = 0;
    double reward_per_rad = 0; // scale from counted rotation to reward
};

struct Setup {
    std::string name;
    ObjectSetup object;
    HandSetup hand;
    PhysicsSetup physics;
    OscillatorSetup oscillators;
    LearnerSetup learner;
    // The merged settings that all of this was read from: one line of JSON, {"section": {"key": value}}, keys sorted.
    std::string settings;
};

// One "section.key=value" override; the value is written as in TOML.
using Override = std::pair<std::string, std::string>;

// Read set-up `name` (a file of `setups_dir`, or a path that ends in .toml), over common.toml, then apply `overrides`.
// Throws std::runtime_error with one sentence that names file, setting and what was expected (unknown or missing keys,
// wrong types, values out of range, a malformed file with its line).
Setup load_setup(const std::filesystem::path &setups_dir, const std::string &name,
                 const std::vector<Override> &overrides = {});

// Read a Setup from merged settings (Setup::settings); `source` is named in errors.
Setup setup_from_settings(const std::string &settings, const std::string &name, const std::string &source);

// The names of all set-ups in `setups_dir`, without common.
std::vector<std::string> setup_names(const std::filesystem::path &setups_dir);

} // namespace twiddle::settings
