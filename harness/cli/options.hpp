// options.hpp: the options that several commands share, and what they stand for.
#pragma once

#include "record/run_json.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::cli
{

// As typed; run_specification() checks them.
struct RunOptions {
    std::string object;
    std::string model;
    bool no_centre = false;
    std::string setup = "paper";
    std::string stepper = "fast";
    std::string hand = "welded";
    std::string number;
    bool number_given = false; // or is it the default
    std::string target = "host";
    std::vector<std::string> overrides; // "section.key=value"
    std::string models_dir;
};

// Add --models alone.
void add_models_option(CLI::App &command, std::string &models_dir);

// Add all of RunOptions.
void add_run_options(CLI::App &command, RunOptions &options);

// The models folder: --models, else the environment's TWIDDLE_MODELS, else where this program was built. Throws UsageError
// if there is none.
std::filesystem::path models_dir(const std::string &option);

// Refuse a name that is no set-up's; the path of a .toml file is taken as it is. Throws UsageError.
void require_setup(const std::filesystem::path &models, const std::string &setup);

// Refuse what this version does not do. Throws UsageError.
void require_supported(const RunOptions &options);
void require_supported(const record::RunSpecification &specification);

// What the options ask for, of `trials` trials from `seed`. Throws UsageError with one sentence for a name or setting that does
// not exist.
record::RunSpecification run_specification(const RunOptions &options, const std::filesystem::path &models,
                                           std::uint64_t seed, std::uint32_t trials);

// `text` as a whole number in [lower, upper]. Throws UsageError that names `option`.
std::uint64_t whole_number(const std::string &option, const std::string &text, std::uint64_t lower,
                           std::uint64_t upper);

// How many runs to do at a time: --jobs, or one a processor where `text` is empty. Throws UsageError.
std::size_t jobs_at_a_time(const std::string &text);

// "a, b, c".
std::string comma_list(const std::vector<std::string> &names);

} // namespace twiddle::cli
