#include "paper_distance_text.hpp"

#include "results_text.hpp"

#include <algorithm>

namespace twiddle::results
{

std::vector<DistanceRow> distance_table(const std::vector<Cell> &cells, const PaperValues &paper,
                                        const std::vector<std::string> &calibration_objects)
{
    std::vector<std::string> held_out;
    for (const std::string &object : paper.objects) {
        const auto found = std::find(calibration_objects.begin(), calibration_objects.end(), object);
        if (found == calibration_objects.end()) held_out.push_back(object);
    }
    std::vector<DistanceRow> rows;
    const auto add = [&](const std::string &name, const std::vector<std::string> &objects) {
        const std::vector<PaperPair> pairs = paper_pairs(cells, paper, objects);
        if (!pairs.empty()) rows.push_back({name, distance_from_paper(pairs)});
    };
    add("calibration", calibration_objects);
    add("held-out", held_out);
    add("all", paper.objects);
    return rows;
}

std::string distance_csv(const Sweep &sweep, const std::vector<DistanceRow> &rows)
{
    std::vector<Texts> lines;
    for (const DistanceRow &row : rows) {
        const PaperDistance &distance = row.distance;
        lines.push_back({row.objects, std::to_string(distance.pairs), full(distance.error_rad), full(distance.scale),
                         full(distance.error_scaled)});
    }
    return csv_text({"distance from the paper's Tables 1 and 2; objects: those that the calibration was compared on, "
                     "the others, all",
                     rotation_text(sweep),
                     "cells: means compared; error_rad: root mean square of ln(ours / paper), rewards read as rad",
                     "error_scaled: the same with ours times scale, the factor that makes it least",
                     origin_text(sweep)},
                    {"objects", "cells", "error_rad", "scale", "error_scaled"}, lines);
}

std::string distance_markdown(const Sweep &sweep, const std::vector<DistanceRow> &rows)
{
    std::vector<Texts> lines;
    for (const DistanceRow &row : rows) {
        const PaperDistance &distance = row.distance;
        lines.push_back({row.objects, std::to_string(distance.pairs), fixed(distance.error_rad, 3),
                         fixed(distance.scale, 3), fixed(distance.error_scaled, 3)});
    }
    return "# Distance of the sweep " + sweep.name + " from the paper's tables\n\n" + origin_text(sweep) +
           ". Root mean square of ln(ours / paper) over the cells that both have, with the paper's rewards read as "
           "rad, and with one "
           "common factor on ours fitted, since the paper does not state its unit. A set-up that was found by "
           "calibration was "
           "compared on the first objects alone; the held-out ones judge it.\n\n" +
           markdown_table({"objects", "cells", "error, rad", "factor", "error with the factor"}, lines);
}

} // namespace twiddle::results
