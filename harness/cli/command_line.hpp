// command_line.hpp: the command line as a command with its options.
#pragma once

#include "options.hpp"

#include <optional>

namespace twiddle::cli
{

// What was asked for; nothing after --help or --version, which are answered on standard output. Throws runs::UsageError
// with one sentence.
std::optional<Command> parse_command_line(int argc, char **argv);

} // namespace twiddle::cli
