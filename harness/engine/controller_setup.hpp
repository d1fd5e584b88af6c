// controller_setup.hpp: a set-up's settings as the C library's configuration.
#pragma once

#include "agent.hpp"
#include "sim/object.hpp"

#include <twiddle/controller.h>
#include <twiddle/learner.h>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

// The controller of the iCub hand's index and thumb, in the joint order of settings/joints.hpp. Throws
// std::runtime_error if the C library refuses a setting.
twd_controller_config controller_config(const ControllerSetup &controller);

// The learner of a run.
twd_learner_config learner_config(const AgentSetup &agent);

// What the learner sees of the object.
LearnerInput learner_input(const sim::ObjectSpec &object, const settings::LearnerSetup &setup);

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
