// paper_distance_text.hpp: how far a sweep is from the paper's tables, as CSV and as Markdown: on the objects that a
// calibration was compared on, on those that it held out, and on all.
#pragma once

#include "paper_distance.hpp"

#include <string>
#include <vector>

namespace twiddle::results
{

// The distance on one group of objects.
struct DistanceRow {
    std::string objects; // "calibration", "held-out" or "all"
    PaperDistance distance;
};

// The groups of which the sweep has cells. `calibration_objects` names the first.
std::vector<DistanceRow> distance_table(const std::vector<Cell> &cells, const PaperValues &paper,
                                        const std::vector<std::string> &calibration_objects);

// The texts of distance.csv and distance.md.
std::string distance_csv(const Sweep &sweep, const std::vector<DistanceRow> &rows);
std::string distance_markdown(const Sweep &sweep, const std::vector<DistanceRow> &rows);

} // namespace twiddle::results
