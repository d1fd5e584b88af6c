// sweep_results.hpp: what the runs of a sweep came to: sweep.json and the runs' folders, read and checked.
//
// A mean over the runs that happen to be there is no result, so all runs that sweep.json lists must be complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace twiddle::results
{

// A run as sweep.json lists it.
struct SweepRun {
    std::string folder;  // relative to the sweep's
    std::string variant; // empty for the sweep's own settings
    std::string object;
    std::string model;
    bool centre = true;
    std::uint64_t seed = 0;
};

// sweep.json.
struct Sweep {
    std::string name;
    std::string version;                        // line of the program that wrote it
    std::uint32_t trials = 0;                   // of every run
    std::map<std::string, std::string> changes; // by variant, "section.key = value, ..."
    std::vector<SweepRun> runs;
};

// A complete run of a cell.
struct CellRun {
    std::string folder; // relative to the sweep's
    std::uint64_t seed = 0;
    std::vector<double> trial_rotation_rad; // of every trial
};

// The runs that differ in nothing but the seed.
struct Cell {
    std::string variant;
    std::string object;
    std::string model;
    bool centre = true;
    std::vector<double> rotation_rad; // one value a run: its mean over the last trials
    std::vector<CellRun> runs;        // in the same order
};

// A run counts with the mean rotation of this many trials at its end, of all where it has fewer.
constexpr std::uint32_t most_last_trials = 500;
std::uint32_t last_trials(const Sweep &sweep);

// Read `folder`/sweep.json. Throws std::runtime_error with one sentence that names the file and what was expected, also
// for a run that is listed twice.
Sweep read_sweep(const std::filesystem::path &folder);

// The cells of the sweep, in the order in which its runs name them. Throws std::runtime_error with one sentence: how
// many runs are not complete and up to five of their folders; or the file that is of another run than listed, or no
// whole log of its trials.
std::vector<Cell> read_cells(const std::filesystem::path &folder, const Sweep &sweep);

} // namespace twiddle::results
