// run_json.hpp: run.json, which names a training run completely: with the models folder, it is enough
// to repeat the run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace twiddle::record
{

// What decides a run's numbers.
struct RunSpecification {
    // E.g. "small-sphere".
    std::string object;
    // E.g. "cpg-h".
    std::string model;
    // Whether oscillators have a centre parameter.
    bool centre = true;
    std::uint64_t seed = 0;
    std::uint32_t trials = 0;
    // "welded" or "full".
    std::string hand;
    // "reference" or "fast".
    std::string stepper;
    // Of the C library: "float", "double" or "fixed".
    std::string number;
    // The set-up's name.
    std::string setup;
    // All settings as resolved, overrides included, as JSON (settings::Setup::settings).
    std::string settings;
};

bool operator==(const RunSpecification &a, const RunSpecification &b);
bool operator!=(const RunSpecification &a, const RunSpecification &b);

// OBJECT/MODEL[-no-centre]/seed-N, where the run's folder stands among those of other runs with the same settings.
std::filesystem::path folder_of(const RunSpecification &specification);

// What a complete run came to.
struct TrainingSummary {
    std::size_t first_trials = 0;
    double mean_rotation_of_first_rad = 0;
    std::size_t last_trials = 0;
    double mean_rotation_of_last_rad = 0;
    // Trials that count as 0 rad.
    std::size_t faults = 0;
};

// What the replay of the learned policy came to.
struct ReplaySummary {
    double rotation_rad = 0;
    double min_finger_clearance_m = 0;
    // Its sentence; the numbers then mean nothing. Empty if there was none.
    std::string fault;
};

// run.json.
struct Run {
    RunSpecification specification;
    // "state": "running" or "complete".
    bool complete = false;
    // As it was typed.
    std::string command;
    // Where the agent computed, which no number depends on: "host", a board, or "port".
    std::string target = "host";
    // The path, for "port".
    std::string port;
    std::optional<TrainingSummary> summary;
    std::optional<ReplaySummary> replay;
};

// Write `run` with this program's versions.
void write_run(const std::filesystem::path &path, const Run &run);

// Read a run.json. Throws std::runtime_error with one sentence that names the file, the key and what was expected.
Run read_run(const std::filesystem::path &path);

} // namespace twiddle::record
