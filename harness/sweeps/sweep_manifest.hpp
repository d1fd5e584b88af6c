// sweep_manifest.hpp: many training runs from one file, a sweep's manifest (experiments/sweeps/NAME.toml):
//
//     trials = 5000                 # of every run
//     setup = "near"                # optional: a set-up's name, or a .toml file beside the manifest
//     stepper = "fast"              # optional
//     [[runs]]                      # one block or more; each is every combination of its lists
//     objects = ["small-sphere"]    # or "all"
//     models = ["cpg-c", "cpg-h"]   # or "all"
//     centre = [true]               # optional
//     seeds = 4                     # 1 to 4
//     variant = "friction-0.8"      # optional: a name for the folder of the block's runs
//     set = { "contact.friction" = 0.8 }   # optional: settings in which the variant differs
#pragma once

#include "record/json.hpp"
#include "record/run_json.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace twiddle::sweeps
{

// A run of a sweep.
struct PlannedRun {
    std::string folder;  // relative to the sweep's: [VARIANT/]OBJECT/MODEL[-no-centre]/seed-N
    std::string variant; // empty for the sweep's own settings
    record::RunSpecification specification;
};

// What a manifest asks for.
struct SweepPlan {
    std::string name;                // the file's, without .toml
    record::RunSpecification common; // what all runs share: trials, hand, stepper, number, set-up and its settings
    std::map<std::string, std::string> overrides; // {"section.key": value}, as JSON, by variant
    std::vector<PlannedRun> runs;                 // block by block; within one by object, model, centre, seed
};

// Where a manifest's names are looked up.
struct SweepFolders {
    std::filesystem::path models;
    std::filesystem::path setups;
};

// Read the manifest `path`; `defaults` gives set-up, stepper, hand and number type where it is silent, and `setup`,
// unless it is empty, the set-up whatever the manifest says. Throws std::runtime_error with one sentence that names
// file, line, key and what was expected: unknown keys and names, values out of range, a run that is listed twice, `set`
// without a variant, one variant with two sets.
SweepPlan read_sweep_manifest(const std::filesystem::path &path, const SweepFolders &folders,
                              const record::RunSpecification &defaults, const std::string &setup = "");

// sweep.json: all that decides the numbers of the sweep's runs, and the runs with their folders.
record::Json sweep_json(const SweepPlan &plan);

} // namespace twiddle::sweeps
