#include "calibration/plan.hpp"
#include "commands.hpp"
#include "errors.hpp"
#include "options.hpp"
#include "record/part_file.hpp"
#include "results/claims_text.hpp"
#include "results/figure_data.hpp"
#include "results/paper_distance_text.hpp"
#include "results/sweep_tables_text.hpp"
#include "results/variant_table_text.hpp"
#include "sweep_folder.hpp"

#include <iostream>
#include <memory>

namespace twiddle::cli
{

namespace
{

struct SummarizeOptions {
    std::string sweep_dir;
    std::string paper_dir = TWIDDLE_PAPER_DIR;
    std::string models_dir;
};

void write_text(const std::filesystem::path &path, const std::string &text)
{
    record::PartFile file(path);
    file.write(text);
    file.finish();
    std::cout << path.string() << '\n';
}

// The objects that the paper's set-up was compared on when it was searched; none where the models folder has no calibration.
std::vector<std::string> calibration_objects(const std::filesystem::path &models)
{
    const std::filesystem::path plan = models / "calibrations" / "paper.toml";
    if (!std::filesystem::exists(plan)) return {};
    return calibration::read_calibration_plan(plan, models).objects;
}

int summarize(const SummarizeOptions &options)
{
    const std::filesystem::path folder = options.sweep_dir;
    if (!std::filesystem::exists(folder / "sweep.json"))
        throw UsageError("'" + options.sweep_dir + "' is no folder of a sweep: it holds no sweep.json");
    const std::filesystem::path paper_dir = options.paper_dir;
    if (!std::filesystem::exists(paper_dir / "table1.csv") || !std::filesystem::exists(paper_dir / "table2.csv"))
        throw UsageError("'" + options.paper_dir +
                         "' does not hold the paper's table1.csv and table2.csv; name their folder by --paper");

    const results::PaperValues paper = results::read_paper_values(paper_dir);
    const results::Sweep sweep = results::read_sweep(folder);
    const std::vector<results::Cell> cells = results::read_cells(folder, sweep);
    const results::SweepTables tables = {results::centre_table(cells, paper), results::model_table(cells, paper)};
    const std::vector<results::ClaimResult> claims =
        results::test_claims(results::read_run_grid(folder, sweep, paper), paper);
    write_text(folder / "table1.csv", results::table1_csv(sweep, tables));
    write_text(folder / "table2.csv", results::table2_csv(sweep, tables));
    write_text(folder / "tables.md", results::tables_markdown(sweep, tables));
    write_text(folder / "claims.csv", results::claims_csv(sweep, claims));
    write_text(folder / "claims.md", results::claims_markdown(sweep, claims));
    const std::vector<results::DistanceRow> distances =
        results::distance_table(cells, paper, calibration_objects(models_dir(options.models_dir)));
    write_text(folder / "distance.csv", results::distance_csv(sweep, distances));
    write_text(folder / "distance.md", results::distance_markdown(sweep, distances));
    const std::filesystem::path figure_data = folder / "figures" / "data";
    make_folder(figure_data);
    write_text(figure_data / "learning_curves.csv", results::learning_curves_csv(sweep, cells));
    write_text(figure_data / "best_runs.csv", results::best_runs_csv(sweep, cells));
    const results::VariantTable variants = results::variant_table(sweep, cells);
    if (!variants.rows.empty()) {
        write_text(folder / "choices.csv", results::variants_csv(sweep, variants));
        write_text(folder / "choices.md", results::variants_markdown(sweep, variants));
    }
    return 0;
}

} // namespace

void add_summarize(CLI::App &app, Session &session)
{
    CLI::App *command = app.add_subcommand(
        "summarize",
        "Make the paper's tables of a complete sweep, test its claims, and make its figures' data; writes "
        "table1.csv, table2.csv, tables.md, claims.csv, claims.md, distance.csv, distance.md, figures/data; of a "
        "sweep with variants also choices.csv, choices.md");
    const auto options = std::make_shared<SummarizeOptions>();
    command->add_option("DIR", options->sweep_dir, "Folder of the sweep, with sweep.json")->required()->type_name("");
    command->add_option("--paper", options->paper_dir, "Folder of the paper's tables as CSV")->type_name("DIR");
    add_models_option(*command, options->models_dir);
    command->callback([options, &session] { session.run = [options] { return summarize(*options); }; });
}

} // namespace twiddle::cli
