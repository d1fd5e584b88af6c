#include "calibration/plan.hpp"
#include "choices.hpp"
#include "claims/claims_text.hpp"
#include "commands.hpp"
#include "record/part_file.hpp"
#include "results/figure_data.hpp"
#include "results/paper_distance_text.hpp"
#include "results/sweep_tables_text.hpp"
#include "results/variant_table_text.hpp"
#include "runs/usage_error.hpp"
#include "sweeps/sweep_folder.hpp"

#include <iostream>

namespace twiddle::cli
{

namespace
{

void write_text(const std::filesystem::path &path, const std::string &text)
{
    record::write_file(path, text);
    std::cout << path.string() << '\n';
}

// The objects that the paper's set-up was compared on when it was searched; none where there is no such calibration.
std::vector<std::string> calibration_objects(const std::filesystem::path &models)
{
    const std::filesystem::path plan = experiments_dir(models) / "calibrations" / "paper.toml";
    if (!std::filesystem::exists(plan)) return {};
    return calibration::read_calibration_plan(plan, models, setups_dir(models)).objects;
}

} // namespace

int run_command(const SummarizeOptions &options, const Arguments & /*arguments*/)
{
    const std::filesystem::path folder = options.sweep_dir;
    if (!std::filesystem::exists(folder / "sweep.json"))
        throw runs::UsageError("'" + options.sweep_dir + "' is no folder of a sweep: it holds no sweep.json");
    const std::filesystem::path paper_folder = paper_dir(options.paper_dir);
    if (!std::filesystem::exists(paper_folder / "table1.csv") || !std::filesystem::exists(paper_folder / "table2.csv"))
        throw runs::UsageError("'" + paper_folder.string() +
                               "' does not hold the paper's table1.csv and table2.csv; name their folder by --paper");

    const results::PaperValues paper = results::read_paper_values(paper_folder);
    const results::Sweep sweep = results::read_sweep(folder);
    const std::vector<results::Cell> cells = results::read_cells(folder, sweep);
    const results::SweepTables tables = {results::centre_table(cells, paper), results::model_table(cells, paper)};
    const std::vector<claims::ClaimResult> tested =
        claims::test_claims(claims::read_run_grid(folder, sweep, paper), paper);
    write_text(folder / "table1.csv", results::table1_csv(sweep, tables));
    write_text(folder / "table2.csv", results::table2_csv(sweep, tables));
    write_text(folder / "tables.md", results::tables_markdown(sweep, tables));
    write_text(folder / "claims.csv", claims::claims_csv(sweep, tested));
    write_text(folder / "claims.md", claims::claims_markdown(sweep, tested));
    const std::vector<results::DistanceRow> distances =
        results::distance_table(cells, paper, calibration_objects(models_dir(options.models_dir)));
    write_text(folder / "distance.csv", results::distance_csv(sweep, distances));
    write_text(folder / "distance.md", results::distance_markdown(sweep, distances));
    const std::filesystem::path figure_data = folder / "figures" / "data";
    sweeps::make_folder(figure_data);
    write_text(figure_data / "learning_curves.csv", results::learning_curves_csv(sweep, cells));
    write_text(figure_data / "best_runs.csv", results::best_runs_csv(sweep, cells));
    const results::VariantTable variants = results::variant_table(sweep, cells);
    if (!variants.rows.empty()) {
        write_text(folder / "choices.csv", results::variants_csv(sweep, variants));
        write_text(folder / "choices.md", results::variants_markdown(sweep, variants));
    }
    return 0;
}

} // namespace twiddle::cli
