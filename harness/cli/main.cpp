// main.cpp: the twiddle program: runs one command, and says what went wrong in one sentence.

#include "command_line.hpp"
#include "commands.hpp"
#include "runs/usage_error.hpp"
#include "sim/not_covered.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{

using namespace twiddle;

constexpr int exit_failure = 1;
constexpr int exit_wrong_use = 2;

int complain(std::string sentence, int status)
{
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    std::cout << std::flush;
    std::cerr << "twiddle: " << sentence << '\n';
    return status;
}

int run(int argc, char **argv)
{
    const std::optional<cli::Command> command = cli::parse_command_line(argc, argv);
    if (!command) return 0;
    const cli::Arguments arguments(argv, argv + argc);
    const int status = std::visit([&](const auto &options) { return cli::run_command(options, arguments); }, *command);
    if (!(std::cout << std::flush)) throw std::runtime_error("cannot write to standard output");
    return status;
}

} // namespace

int main(int argc, char **argv)
{
    try {
        return run(argc, argv);
    } catch (const sim::NotCovered &error) {
        return complain(error.what(), exit_wrong_use);
    } catch (const runs::UsageError &error) {
        return complain(error.what(), exit_wrong_use);
    } catch (const std::exception &error) {
        return complain(error.what(), exit_failure);
    }
}
