// run_json.hpp: run.json, which names a training run completely: with the models folder, it is enough to repeat the run.
#pragma once

#include "json_file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace twiddle::record
{

// What decides a run's numbers.
struct RunSpecification {
    std::string object; // e.g. "small-sphere"
    std::string model;  // e.g. "cpg-h"
    bool centre = true; // oscillators have a centre parameter
    std::uint64_t seed = 0;
    std::uint32_t trials = 0;
    std::string hand;        // "welded" or "full"
    std::string stepper;     // "reference" or "fast"
    std::string number;      // of the C library: "float" or "double"
    std::string setup;       // the set-up's name
    nlohmann::json settings; // all settings as resolved, overrides included (Setup::settings)
};

bool operator==(const RunSpecification &a, const RunSpecification &b);
bool operator!=(const RunSpecification &a, const RunSpecification &b);

// OBJECT/MODEL[-no-centre]/seed-N, where the run's folder stands among those of other runs with the same settings.
std::filesystem::path folder_of(const RunSpecification &specification);

// run.json.
struct Run {
    RunSpecification specification;
    bool complete = false;       // "state": "running" or "complete"
    std::string command;         // as it was typed
    std::string target = "host"; // where the agent computed, which no number depends on: "host", a board, or "port"
    std::string port;            // the path, for "port"
    Json summary;                // results in short; null while there are none
    Json replay;                 // of the learned policy; null while there is none
};

// Write `run` with this program's versions.
void write_run(const std::filesystem::path &path, const Run &run);

// Read a run.json. Throws std::runtime_error with one sentence that names the file, the key and what was expected.
Run read_run(const std::filesystem::path &path);

} // namespace twiddle::record
