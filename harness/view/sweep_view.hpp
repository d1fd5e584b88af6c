// sweep_view.hpp: what the index page shows of a sweep: which runs there are, and how far their replays turned.
#pragma once

#include "results/sweep_results.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace twiddle::view
{

// A run of the sweep, complete or not.
struct IndexCell {
    results::SweepRun run;
    // Whether it has a replay to show.
    bool has_page = false;
    // Of the replay; nothing if there is none, or one that had a fault.
    std::optional<double> rotation_rad;
    // Mean over the training's last trials.
    std::optional<double> trained_rad;
    // The sentence of the replay's fault; empty if there was none.
    std::string fault;
};

struct SweepView {
    std::string name;
    std::string version;
    // In the order of sweep.json.
    std::vector<IndexCell> cells;
};

// Read sweep.json in `folder`, and run.json of each of its runs. Throws std::runtime_error with one sentence, also for
// a run whose folder is not below `folder`.
SweepView read_sweep_view(const std::filesystem::path &folder);

} // namespace twiddle::view
