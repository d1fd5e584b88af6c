// configured_chip_agent.hpp: an agent on a chip, made from configurations of the C library.
#pragma once

#include "connection.hpp"
#include "engine/agent.hpp"

#include <twiddle/controller.h>
#include <twiddle/learner.h>

#include <memory>
#include <string>

namespace twiddle::link
{

// What a chip is sent.
struct ChipConfig {
    // Of the set-up, for sentences.
    std::string name;
    twd_controller_config controller{};
    twd_learner_config learner{};
};

// Throws std::runtime_error for a set-up that the library refuses.
ChipConfig chip_config(const engine::AgentSetup &setup);

// As make_chip_agent() (chip_agent.hpp).
std::unique_ptr<engine::Agent> make_configured_chip_agent(std::unique_ptr<Connection> connection,
                                                          const ChipConfig &config);

} // namespace twiddle::link
