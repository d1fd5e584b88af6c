// variant_table.hpp: what the variants of a sweep change: each beside the same runs with the sweep's own
// settings, its base.
#pragma once

#include "statistics.hpp"
#include "sweep_results.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace twiddle::results
{

// A model as a sweep trains it.
struct ModelCondition {
    std::string model;
    bool centre = true;
};

// A variant against the base, for one model, over the objects that both have; each object counts the same.
struct VariantEffect {
    ModelCondition condition;
    std::size_t objects = 0;
    std::size_t runs = 0;      // of the variant
    std::size_t base_runs = 0; // on the same objects
    double mean_rad = 0;
    double base_mean_rad = 0;
    double difference_rad = 0;            // mean_rad - base_mean_rad
    std::optional<Interval> interval_rad; // of the difference; none if a cell has a single run
    bool same_runs = false;               // every rotation is the base's, digit for digit
};

// All that is known of one variant.
struct VariantRow {
    std::string variant;
    std::string changes; // "section.key = value, ..."
    std::vector<VariantEffect>
        effects; // those that can be compared with the base, in the order of VariantTable's conditions
};

struct VariantTable {
    std::vector<ModelCondition> conditions; // of the base, CPG-H first, then as the sweep names them
    std::vector<VariantRow> rows;           // the one with the largest difference in size first
};

// The table of all variants; no rows if the sweep has none. `cells` are the sweep's.
VariantTable variant_table(const Sweep &sweep, const std::vector<Cell> &cells);

} // namespace twiddle::results
