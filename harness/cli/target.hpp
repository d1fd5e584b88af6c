// target.hpp: where a run's agent computes: in this process, on an emulated chip, or on a chip at a port.
#pragma once

#include "engine/agent.hpp"
#include "options.hpp"

#include <string>

namespace twiddle::cli
{

struct Target {
    // "host", an emulated board, or "port".
    std::string name;
    // The path, for "port".
    std::string port;
    // bit/s, for "port".
    unsigned baud = 0;
    // The number type that computes there.
    std::string number;
};

// What the options ask for. Chips compute in fixed point: throws runs::UsageError for another --number, and for a speed
// that no port has.
Target target_of(const RunOptions &run, const PortOptions &port);

// How the agent of a run on `target` is made; for a chip, throws link::LinkError if it does not answer, and
// std::runtime_error if there is no firmware for it.
engine::AgentMaker agent_maker(const Target &target);

} // namespace twiddle::cli
