// sweep_tables.hpp: the numbers of the paper's two tables, from the cells of a sweep.
//
// A cell that the sweep does not have is left out; what it has is complete (sweep_results.hpp).
#pragma once

#include "paper_values.hpp"
#include "statistics.hpp"
#include "sweep_results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace twiddle::results
{

// What is said about one cell. The spread of a single run is not known.
struct CellSummary {
    std::string variant;
    std::string object;
    std::string model;
    bool centre = true;
    std::size_t runs = 0;
    double mean_rad = 0;
    std::optional<double> sd_rad;
    double best_rad = 0;
    std::optional<Interval> interval_rad; // of the mean
};

CellSummary summary_of(const Cell &cell);

// A row of Table 1.
struct CentreRow {
    CellSummary cell;
    std::optional<double> p;  // Mann-Whitney against the same model with centre; in the row without
    std::string paper_reward; // empty where the paper has none
};

// Table 1: CPG-H with and without centre; also the other models that the sweep has without centre. By
// variant, object, model.
std::vector<CentreRow> centre_table(const std::vector<Cell> &cells, const PaperValues &paper);

// A model against the object's winner.
struct Comparison {
    double p = 1;               // Mann-Whitney, two-sided
    double p_holm = 1;          // corrected over the object's comparisons
    double smallest_p_holm = 1; // that groups of these sizes can give without ties
};

// A row of Table 2.
struct ModelRow {
    CellSummary cell;
    bool winner = false;                  // the highest mean of the object's models, where there are two or more
    std::optional<Comparison> comparison; // of the others with the winner
    PaperCell paper;                      // empty where the paper has none
};

// Table 2: the four models with centre. By variant, object, model.
std::vector<ModelRow> model_table(const std::vector<Cell> &cells, const PaperValues &paper);

} // namespace twiddle::results
