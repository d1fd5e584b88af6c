// controller_setup.hpp: a set-up's settings as the C library's configuration.
#pragma once

#include "number.hpp"
#include "sim/object.hpp"
#include "sim/setup.hpp"

#include <twiddle/controller.h>
#include <twiddle/input_map.h>
#include <twiddle/learner.h>

#include <array>
#include <cstdint>

namespace twiddle::experiment
{

constexpr double control_step_s = 0.01; // the paper's

// The controller of the iCub hand's index and thumb, in the joint order of sim/joints.hpp. Throws std::runtime_error if the C
// library refuses a setting.
twd_controller_config controller_config(const sim::Setup &setup, const twd_model &model, bool with_centre);

// The learner of a run of `trials` trials.
twd_learner_config learner_config(const sim::LearnerSetup &setup, const twd_model &model, bool with_centre,
                                  std::uint32_t trials, std::uint64_t seed);

// What the learner sees of the object.
using LearnerInput = std::array<twd_num, TWD_INPUTS>;
LearnerInput learner_input(const sim::ObjectSpec &object, const sim::LearnerSetup &setup);

} // namespace twiddle::experiment
