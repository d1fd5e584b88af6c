#include "sweep_tables_text.hpp"

#include "mann_whitney.hpp"
#include "results_text.hpp"

#include <algorithm>

namespace twiddle::results
{

namespace
{

const Texts cell_columns = {"variant",  "object", "model",    "centre",    "runs",
                            "mean_rad", "sd_rad", "best_rad", "lower_rad", "upper_rad"};

const std::string bootstrap_text = "95 % percentile bootstrap interval of the mean, " +
                                   std::to_string(bootstrap_resamples) + " resamples from a fixed seed";

const std::string exact_text = "exact without ties and up to " + std::to_string(exact_group_size) +
                               " runs a cell, else by the normal approximation corrected for ties";

Texts csv_cells(const CellSummary &cell)
{
    const std::optional<Interval> &interval = cell.interval_rad;
    return {cell.variant,
            cell.object,
            cell.model,
            truth_cell(cell.centre),
            std::to_string(cell.runs),
            full(cell.mean_rad),
            full(cell.sd_rad),
            full(cell.best_rad),
            interval ? full(interval->lower) : "",
            interval ? full(interval->upper) : ""};
}

std::string p_text(double p)
{
    return p < 0.0001 ? "< 0.0001" : fixed(p, 4);
}

// A table, or a sentence where the sweep has nothing for it.
std::string table_or_sentence(const Texts &columns, const std::vector<Texts> &rows)
{
    return rows.empty() ? "The sweep has no runs of this table.\n" : markdown_table(columns, rows);
}

const Texts markdown_cell_columns = {"variant",       "object", "model", "rotation (rad): mean ± sd (best)",
                                     "95 % interval", "runs"};

Texts markdown_cells(const CellSummary &cell)
{
    const std::optional<Interval> &interval = cell.interval_rad;
    return {cell.variant.empty() ? "-" : cell.variant,
            cell.object,
            model_text(cell.model, cell.centre),
            fixed(cell.mean_rad, 3) + " ± " + (cell.sd_rad ? fixed(*cell.sd_rad, 3) : "-") + " (" +
                fixed(cell.best_rad, 3) + ")",
            interval ? fixed(interval->lower, 3) + " to " + fixed(interval->upper, 3) : "-",
            std::to_string(cell.runs)};
}

std::string paper_text(const PaperCell &paper)
{
    return paper.mean.empty() ? "-" : paper.mean + " ± " + paper.sd + " (" + paper.best + ")";
}

std::string comparison_text(const ModelRow &row)
{
    if (row.winner) return "winner";
    return row.comparison ? p_text(row.comparison->p_holm) + " (" + p_text(row.comparison->p) + ")" : "-";
}

std::string table1_markdown(const SweepTables &tables)
{
    std::vector<Texts> rows;
    for (const CentreRow &row : tables.centre) {
        rows.push_back(joined(markdown_cells(row.cell),
                              {row.p ? p_text(*row.p) : "-", row.paper_reward.empty() ? "-" : row.paper_reward}));
    }
    return table_or_sentence(joined(markdown_cell_columns, {"p, with against without", "paper's reward"}), rows);
}

std::string table2_markdown(const SweepTables &tables)
{
    std::vector<Texts> rows;
    for (const ModelRow &row : tables.models) {
        rows.push_back(joined(markdown_cells(row.cell), {comparison_text(row), paper_text(row.paper)}));
    }
    return table_or_sentence(joined(markdown_cell_columns, {"p against the winner (uncorrected)", "paper's reward"}),
                             rows);
}

// How small a corrected p can be: with few runs, no difference however large is significant.
std::string smallest_p_sentence(const SweepTables &tables)
{
    std::optional<double> smallest;
    for (const ModelRow &row : tables.models) {
        if (row.comparison) smallest = std::min(smallest.value_or(1.0), row.comparison->smallest_p_holm);
    }
    if (!smallest) return "";
    return " The smallest corrected p that these numbers of runs can give, without ties, is " + p_text(*smallest) + ".";
}

std::string definitions(const Sweep &sweep, const SweepTables &tables)
{
    Texts lines;
    lines.push_back(
        "rotation: " + rotation_text(sweep) +
        "; mean, standard deviation (n - 1) and best are over the runs of a cell, which differ in the seed alone.");
    lines.push_back("95 % interval: " + bootstrap_text +
                    ". With few runs it is too narrow: with four it covers the true mean about 81 times in 100.");
    lines.push_back("winner: the highest mean of the object's models. The same runs choose it and are then compared, "
                    "which favours small p.");
    lines.push_back("p: two-sided Mann-Whitney U test, " + exact_text +
                    "; against the winner also corrected by Holm over the object's comparisons." +
                    smallest_p_sentence(tables));
    lines.push_back(
        "paper's reward: as printed, Table 1 one value, Table 2 mean ± sd (best) of four runs; its unit is not "
        "stated, so compare the order of the cells, not the values.");
    std::string text = "## How each number is defined\n\n";
    for (const std::string &line : lines) {
        text += "- " + line + "\n";
    }
    return text;
}

} // namespace

std::string table1_csv(const Sweep &sweep, const SweepTables &tables)
{
    std::vector<Texts> rows;
    for (const CentreRow &row : tables.centre) {
        rows.push_back(joined(csv_cells(row.cell), {full(row.p), row.paper_reward}));
    }
    return csv_text(
        {"Table 1: CPG-H with and without the parameters that set the centres of oscillation, beside the "
         "paper's; other models where the sweep has them without centre",
         rotation_text(sweep) + "; sd_rad: n - 1", "lower_rad, upper_rad: " + bootstrap_text,
         "p: two-sided Mann-Whitney U test of without against with centre, " + exact_text + "; not corrected",
         "paper_reward: as printed, unit not stated", origin_text(sweep)},
        joined(cell_columns, {"p", "paper_reward"}), rows);
}

std::string table2_csv(const Sweep &sweep, const SweepTables &tables)
{
    std::vector<Texts> rows;
    for (const ModelRow &row : tables.models) {
        const std::optional<Comparison> &comparison = row.comparison;
        rows.push_back(joined(csv_cells(row.cell), {truth_cell(row.winner), comparison ? full(comparison->p) : "",
                                                    comparison ? full(comparison->p_holm) : "", row.paper.mean,
                                                    row.paper.sd, row.paper.best}));
    }
    return csv_text({"Table 2: the four models with centre, beside the paper's",
                     rotation_text(sweep) + "; sd_rad: n - 1", "lower_rad, upper_rad: " + bootstrap_text,
                     "winner: the highest mean of the object's models",
                     "p: two-sided Mann-Whitney U test against the winner, " + exact_text +
                         "; p_holm: corrected over the object's comparisons",
                     "paper_mean, paper_sd, paper_best: reward as printed, unit not stated", origin_text(sweep)},
                    joined(cell_columns, {"winner", "p", "p_holm", "paper_mean", "paper_sd", "paper_best"}), rows);
}

std::string tables_markdown(const Sweep &sweep, const SweepTables &tables)
{
    return "# Tables of the sweep " + sweep.name + "\n\n" + origin_text(sweep) +
           ". Rotations in rad; definitions below.\n\n"
           "## Table 1: with and without centre\n\n" +
           table1_markdown(tables) + "\n## Table 2: the four models\n\n" + table2_markdown(tables) + "\n" +
           definitions(sweep, tables);
}

} // namespace twiddle::results
