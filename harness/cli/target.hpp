// target.hpp: where a run's agent computes: in this process, on an emulated chip, or on a chip at a port.
#pragma once

#include "experiment/agent.hpp"
#include "link/connection.hpp"
#include "options.hpp"

#include <string>
#include <vector>

namespace twiddle::cli
{

// What --target may be: "host", and the emulated boards.
std::vector<std::string> targets();

// As typed; target_of() checks them.
struct PortOptions {
    std::string port; // empty: none
    std::string baud = "115200";
};

// Add --port, which excludes the --target that is already there, and --baud.
void add_port_options(CLI::App &command, PortOptions &options);

struct Target {
    std::string name;   // "host", an emulated board, or "port"
    std::string port;   // the path, for "port"
    unsigned baud = 0;  // bit/s, for "port"
    std::string number; // the number type that computes there
};

// What the options ask for. Chips compute in fixed point: throws UsageError for another --number, and for a speed that
// no port has.
Target target_of(const RunOptions &run, const PortOptions &port);

// How the agent of a run on `target` is made; for a chip, throws link::LinkError if it does not answer, and
// std::runtime_error if there is no firmware for it.
experiment::AgentMaker agent_maker(const Target &target);

} // namespace twiddle::cli
