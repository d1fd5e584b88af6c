// options.hpp: the options of every command, as typed; choices.hpp checks what several commands share.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace twiddle::cli
{

// Which skill, in which set-up.
struct RunOptions {
    std::string object;
    std::string model;
    bool no_centre = false;
    std::string setup = "paper";
    std::string stepper = "fast";
    std::string hand = "welded";
    std::string number = "float";
    // Or is `number` the default?
    bool number_given = false;
    std::string target = "host";
    // "section.key=value"
    std::vector<std::string> overrides;
    std::string models_dir;
};

// A board at a serial port.
struct PortOptions {
    // Empty: none.
    std::string port;
    std::string baud = "115200";
};

struct TrainOptions {
    RunOptions run;
    PortOptions port;
    std::string seed = "1";
    std::string trials = "5000";
    std::string out;
    bool resume = false;
};

struct SweepOptions {
    std::string manifest;
    std::string out;
    std::string jobs;
    std::string only;
    // Instead of the manifest's; empty: the manifest's.
    std::string setup;
    std::string number = "float";
    std::string models_dir;
    bool list_missing = false;
};

struct CalibrateOptions {
    std::string plan;
    std::string out;
    std::string jobs;
    std::string number = "float";
    std::string models_dir;
    // Empty: the repository's.
    std::string paper_dir;
};

struct ReplayOptions {
    std::string run_dir;
    std::string out;
    // Empty: the run's own.
    std::string stepper;
    std::string models_dir;
};

struct RolloutOptions {
    RunOptions run;
};

struct ExportOptions {
    std::string run_dir;
    bool c_header = false;
    // Empty: of object and model.
    std::string name;
    // Empty: standard output.
    std::string out;
    std::string models_dir;
};

struct SummarizeOptions {
    std::string sweep_dir;
    // Empty: the repository's.
    std::string paper_dir;
    std::string models_dir;
};

struct CompareClaimsOptions {
    std::vector<std::string> sweep_dirs;
};

struct ViewOptions {
    // Folder of a run or of a sweep.
    std::string dir;
    std::string out;
    // Another run's folder, to be shown beside.
    std::string compare;
    bool index_only = false;
    std::string models_dir;
};

struct InfoOptions {
    std::string models_dir;
};

// One command.
using Command = std::variant<TrainOptions, SweepOptions, CalibrateOptions, ReplayOptions, RolloutOptions, ExportOptions,
                             SummarizeOptions, CompareClaimsOptions, ViewOptions, InfoOptions>;

} // namespace twiddle::cli
