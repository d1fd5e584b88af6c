#include "variant_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace twiddle::results
{

namespace
{

const std::string base; // the variant without a name
const std::string foremost_model = "cpg-h";

bool is_of(const Cell &cell, const std::string &variant, const ModelCondition &condition)
{
    return std::tie(cell.variant, cell.model, cell.centre) == std::tie(variant, condition.model, condition.centre);
}

std::vector<ModelCondition> conditions_of_base(const std::vector<Cell> &cells)
{
    std::vector<ModelCondition> conditions;
    for (const Cell &cell : cells) {
        const bool is_known = std::any_of(conditions.begin(), conditions.end(), [&](const ModelCondition &known) {
            return is_of(cell, cell.variant, known);
        });
        if (cell.variant == base && !is_known) conditions.push_back({cell.model, cell.centre});
    }
    std::stable_partition(conditions.begin(), conditions.end(),
                          [](const ModelCondition &condition) { return condition.model == foremost_model; });
    return conditions;
}

// One change for every object that both the variant and the base have.
std::vector<CellChange> changes_of(const std::vector<Cell> &cells, const std::string &variant,
                                   const ModelCondition &condition)
{
    std::vector<CellChange> found;
    for (const Cell &changed : cells) {
        if (!is_of(changed, variant, condition)) continue;
        for (const Cell &unchanged : cells) {
            if (is_of(unchanged, base, condition) && unchanged.object == changed.object)
                found.push_back({changed.rotation_rad, unchanged.rotation_rad});
        }
    }
    return found;
}

VariantEffect effect_of(const std::vector<CellChange> &objects, const ModelCondition &condition)
{
    VariantEffect effect;
    effect.condition = condition;
    effect.objects = objects.size();
    bool has_spread = true;
    effect.same_runs = true;
    for (const CellChange &object : objects) {
        effect.runs += object.changed.size();
        effect.base_runs += object.base.size();
        effect.mean_rad += mean(object.changed) / static_cast<double>(objects.size());
        effect.base_mean_rad += mean(object.base) / static_cast<double>(objects.size());
        effect.same_runs = effect.same_runs && object.changed == object.base;
        has_spread = has_spread && object.changed.size() > 1 && object.base.size() > 1;
    }
    effect.difference_rad = mean_difference(objects);
    if (has_spread) effect.interval_rad = bootstrap_interval_of_mean_difference(objects);
    return effect;
}

double largest_difference(const VariantRow &row)
{
    double largest = 0;
    for (const VariantEffect &effect : row.effects) {
        largest = std::max(largest, std::abs(effect.difference_rad));
    }
    return largest;
}

} // namespace

VariantTable variant_table(const Sweep &sweep, const std::vector<Cell> &cells)
{
    VariantTable table;
    table.conditions = conditions_of_base(cells);
    for (const Cell &cell : cells) {
        const bool is_known = std::any_of(table.rows.begin(), table.rows.end(),
                                          [&](const VariantRow &row) { return row.variant == cell.variant; });
        if (cell.variant == base || is_known) continue;
        const auto changes = sweep.changes.find(cell.variant);
        VariantRow row{cell.variant, changes == sweep.changes.end() ? "" : changes->second, {}};
        for (const ModelCondition &condition : table.conditions) {
            const std::vector<CellChange> objects = changes_of(cells, row.variant, condition);
            if (!objects.empty()) row.effects.push_back(effect_of(objects, condition));
        }
        table.rows.push_back(row);
    }
    std::stable_sort(table.rows.begin(), table.rows.end(), [](const VariantRow &a, const VariantRow &b) {
        return largest_difference(a) > largest_difference(b);
    });
    return table;
}

} // namespace twiddle::results
