// The stand-in for chip_agent.cpp in programs whose numbers no chip shares.
#include "chip_agent.hpp"

#include <stdexcept>

namespace twiddle::link
{

std::unique_ptr<experiment::Agent> make_chip_agent(std::unique_ptr<Connection> /*connection*/,
                                                   const experiment::AgentSetup & /*setup*/)
{
    throw std::logic_error("a chip computes in fixed point; this program's numbers are " TWD_NUMBER_NAME);
}

} // namespace twiddle::link
