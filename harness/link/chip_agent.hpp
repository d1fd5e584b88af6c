// chip_agent.hpp: an agent on a chip: learner and controller run there, the world runs here.
#pragma once

#include "connection.hpp"
#include "experiment/agent.hpp"

#include <memory>

namespace twiddle::link
{

// Greet the chip and configure it. The agent's functions throw LinkError. A chip computes in fixed point: in a program
// of another number type, this throws std::logic_error.
std::unique_ptr<experiment::Agent> make_chip_agent(std::unique_ptr<Connection> connection,
                                                   const experiment::AgentSetup &setup);

} // namespace twiddle::link
