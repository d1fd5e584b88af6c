// run_grid.hpp: the measured runs of a sweep by object, model and centre; and the paper's tables in the same form.
#pragma once

#include "results/paper_values.hpp"
#include "run_measures.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace twiddle::claims
{

// The runs of one cell, which differ in the seed alone.
using Runs = std::vector<RunMeasures>;

// Object, model ("cpg-h"), and whether with the centre parameters.
using CellKey = std::tuple<std::string, std::string, bool>;

struct RunGrid {
    std::vector<std::string> objects; // in the paper's order, others after
    std::map<CellKey, Runs> cells;

    // The cell's runs; null where there are none.
    const Runs *find(const std::string &object, const std::string &model, bool centre = true) const;
};

// Read the runs of the sweep's own settings (no variant). The sweep must be complete (read_cells); throws as
// read_run_measures.
RunGrid read_run_grid(const std::filesystem::path &folder, const results::Sweep &sweep,
                      const results::PaperValues &paper);

// The paper's tables as made-up runs, so that its values go through the same measures as ours:
// Table 1's rewards, one run a cell.
RunGrid grid_of_table1(const results::PaperValues &paper);
// Table 2's means and standard deviations: four runs a cell, as the paper states, half of them at mean - d and half at
// mean + d with d = sd sqrt 3 / 2, which have both. Intervals of means are then those of the paper's own spread; how
// sure a spread is they do not say.
RunGrid grid_of_table2(const results::PaperValues &paper);
// Table 2's best runs, one run a cell.
RunGrid grid_of_best(const results::PaperValues &paper);

} // namespace twiddle::claims
