// choices.hpp: what the options that several commands share stand for. All throw runs::UsageError with one sentence.
#pragma once

#include "options.hpp"
#include "record/run_json.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::cli
{

// The models folder: --models, else the environment's TWIDDLE_MODELS, else where this program was built. Throws
// if there is none.
std::filesystem::path models_dir(const std::string &option);

// Where set-ups and calibrations are: `models` if it has setups/ of its own, else the experiments folder where this
// program was built.
std::filesystem::path experiments_dir(const std::filesystem::path &models);
std::filesystem::path setups_dir(const std::filesystem::path &models);

// The folder of the paper's tables: --paper, else where this program was built.
std::filesystem::path paper_dir(const std::string &option);

// What --target may be: "host", and the emulated boards.
std::vector<std::string> targets();

// Refuse a name that is no set-up's; the path of a .toml file is taken as it is.
void require_setup(const std::filesystem::path &models, const std::string &setup);

// Refuse a name that is no number type's.
void require_number(const std::string &number);

// Refuse what this version does not do.
void require_supported(const RunOptions &options);
void require_supported(const record::RunSpecification &specification);

// What the options ask for, of `trials` trials from `seed`. Throws for a name or setting that does not exist.
record::RunSpecification run_specification(const RunOptions &options, const std::filesystem::path &models,
                                           std::uint64_t seed, std::uint32_t trials);

// `text` as a whole number in [lower, upper]. Throws with the name `option`.
std::uint64_t whole_number(const std::string &option, const std::string &text, std::uint64_t lower,
                           std::uint64_t upper);

// How many runs to do at a time: --jobs, or one a processor where `text` is empty.
std::size_t jobs_at_a_time(const std::string &text);

// "a, b, c".
std::string comma_list(const std::vector<std::string> &names);

} // namespace twiddle::cli
