#include "variant_table_text.hpp"

#include "results_text.hpp"

#include <algorithm>

namespace twiddle::results
{

namespace
{

const std::string resampling_text = "95 % percentile bootstrap interval of the difference, " +
                                    std::to_string(bootstrap_resamples) +
                                    " resamples of the runs within each object from a fixed seed";

std::string signed_text(double value, int digits)
{
    const std::string text = fixed(value, digits);
    return value < 0 ? text : "+" + text;
}

Texts csv_cells(const std::string &variant, const VariantEffect &effect)
{
    const std::optional<Interval> &interval = effect.interval_rad;
    return {variant,
            effect.condition.model,
            truth_cell(effect.condition.centre),
            std::to_string(effect.objects),
            std::to_string(effect.runs),
            std::to_string(effect.base_runs),
            full(effect.mean_rad),
            full(effect.base_mean_rad),
            full(effect.difference_rad),
            interval ? full(interval->lower) : "",
            interval ? full(interval->upper) : "",
            truth_cell(effect.same_runs)};
}

// "5.12 (+0.46, 0.12 to 0.79)", "5.12 (the same runs)".
std::string effect_text(const VariantRow &row, const ModelCondition &condition)
{
    const auto effect = std::find_if(row.effects.begin(), row.effects.end(), [&](const VariantEffect &each) {
        return each.condition.model == condition.model && each.condition.centre == condition.centre;
    });
    if (effect == row.effects.end()) return "-";
    if (effect->same_runs) return fixed(effect->mean_rad, 2) + " (the same runs)";
    const std::string interval = effect->interval_rad ? ", " + fixed(effect->interval_rad->lower, 2) + " to " +
                                                            fixed(effect->interval_rad->upper, 2)
                                                      : "";
    return fixed(effect->mean_rad, 2) + " (" + signed_text(effect->difference_rad, 2) + interval + ")";
}

// The base's means, from a variant that is compared with all of it.
std::string base_sentence(const VariantTable &table)
{
    Texts means;
    for (const ModelCondition &condition : table.conditions) {
        const VariantEffect *widest = nullptr;
        for (const VariantRow &row : table.rows) {
            for (const VariantEffect &effect : row.effects) {
                if (effect.condition.model != condition.model || effect.condition.centre != condition.centre) continue;
                if (!widest || effect.objects > widest->objects) widest = &effect;
            }
        }
        if (widest)
            means.push_back(model_text(condition.model, condition.centre) + " " + fixed(widest->base_mean_rad, 2) +
                            " rad over " + std::to_string(widest->objects) + " objects");
    }
    std::string list;
    for (const std::string &mean : means) {
        list += (list.empty() ? "" : ", ") + mean;
    }
    return "Without a change: " + list + ".";
}

std::string definitions(const Sweep &sweep)
{
    return "- rotation: " + rotation_text(sweep) +
           "; the mean of a model's runs on each object, then over the objects.\n"
           "- difference: to the same model's runs on the same objects without the change. The largest, of whatever "
           "sign and model, comes first. \"The same runs\": every rotation is the same, digit for digit; the change "
           "does not reach the model, or is the set-up's own value.\n"
           "- interval: " +
           resampling_text +
           ". With five runs a cell it is about a tenth too narrow; and of twenty intervals one would leave out 0 if "
           "nothing had an effect.\n";
}

} // namespace

std::string variants_csv(const Sweep &sweep, const VariantTable &table)
{
    Texts comments = {"the variants of the sweep, each beside the same runs with the sweep's own settings",
                      rotation_text(sweep) + "; mean_rad: of the runs on each object, then over the objects",
                      "difference_rad: mean_rad - base_mean_rad; lower_rad, upper_rad: " + resampling_text,
                      "same_runs: every rotation is the base's, digit for digit", origin_text(sweep)};
    std::vector<Texts> rows;
    for (const VariantRow &row : table.rows) {
        comments.push_back("variant " + row.variant + ": " + row.changes);
        for (const VariantEffect &effect : row.effects) {
            rows.push_back(csv_cells(row.variant, effect));
        }
    }
    return csv_text(comments,
                    {"variant", "model", "centre", "objects", "runs", "base_runs", "mean_rad", "base_mean_rad",
                     "difference_rad", "lower_rad", "upper_rad", "same_runs"},
                    rows);
}

std::string variants_markdown(const Sweep &sweep, const VariantTable &table)
{
    Texts columns = {"variant", "change"};
    for (const ModelCondition &condition : table.conditions) {
        columns.push_back(model_text(condition.model, condition.centre) + ": rotation (difference, 95 % interval)");
    }
    std::vector<Texts> rows;
    for (const VariantRow &row : table.rows) {
        Texts cells = {row.variant, row.changes.empty() ? "-" : "`" + row.changes + "`"};
        for (const ModelCondition &condition : table.conditions) {
            cells.push_back(effect_text(row, condition));
        }
        rows.push_back(cells);
    }
    return "# Variants of the sweep " + sweep.name + "\n\n" + origin_text(sweep) + ". Rotations in rad. " +
           base_sentence(table) + "\n\n" + markdown_table(columns, rows) + "\n## How each number is defined\n\n" +
           definitions(sweep);
}

} // namespace twiddle::results
