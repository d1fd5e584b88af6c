// commands.hpp: the program's commands. Each adds itself to the command line; main.cpp runs the one that was given.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace twiddle::cli
{

// What a command line is made into.
struct Session {
    std::vector<std::string> arguments; // as typed, the program's name first
    std::function<int()> run;           // the command that was given; returns the exit status
};

void add_train(CLI::App &app, Session &session);
void add_sweep(CLI::App &app, Session &session);
void add_calibrate(CLI::App &app, Session &session);
void add_replay(CLI::App &app, Session &session);
void add_rollout(CLI::App &app, Session &session);
void add_export(CLI::App &app, Session &session);
void add_summarize(CLI::App &app, Session &session);
void add_compare_claims(CLI::App &app, Session &session);
void add_info(CLI::App &app, Session &session);

} // namespace twiddle::cli
