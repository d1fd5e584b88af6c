// chip_agent.hpp: an agent on a chip: learner and controller run there, in fixed point; the world runs here.
#pragma once

#include "connection.hpp"
#include "engine/agent.hpp"

#include <memory>

namespace twiddle::link
{

// Greet the chip and configure it. The agent's functions throw LinkError.
std::unique_ptr<engine::Agent> make_chip_agent(std::unique_ptr<Connection> connection, const engine::AgentSetup &setup);

} // namespace twiddle::link
