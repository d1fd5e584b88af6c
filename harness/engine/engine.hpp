// engine.hpp: the C library in this process behind one plain interface, one engine a number type.
#pragma once

#include "agent.hpp"
#include "sim/object.hpp"

#include <memory>
#include <string>
#include <vector>

namespace twiddle::engine
{

// The library of one number type, as functions.
struct Engine {
    // Throws std::runtime_error, which names the set-up, for one that the library refuses.
    std::unique_ptr<Controller> (*make_controller)(const ControllerSetup &setup);

    // The same.
    std::unique_ptr<Agent> (*make_agent)(const AgentSetup &setup);

    // What the learner sees of an object.
    LearnerInput (*learner_input)(const sim::ObjectSpec &object, const settings::LearnerSetup &setup);

    // The reward as the library holds it.
    double (*rounded_reward)(double reward);
};

// The number types: "float", "double", "fixed"; the first is the default.
const std::vector<std::string> &number_names();

// Throws std::out_of_range for a name that is none.
const Engine &engine_of_number(const std::string &number);

} // namespace twiddle::engine
