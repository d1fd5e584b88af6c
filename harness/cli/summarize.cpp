#include "commands.hpp"
#include "errors.hpp"
#include "experiment/claims_text.hpp"
#include "experiment/sweep_tables_text.hpp"
#include "record/part_file.hpp"

#include <iostream>
#include <memory>

namespace twiddle::cli
{

namespace
{

struct SummarizeOptions {
    std::string sweep_dir;
    std::string paper_dir = TWIDDLE_PAPER_DIR;
};

void write_text(const std::filesystem::path &path, const std::string &text)
{
    record::PartFile file(path);
    file.write(text);
    file.finish();
    std::cout << path.string() << '\n';
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

    const experiment::PaperValues paper = experiment::read_paper_values(paper_dir);
    const experiment::Sweep sweep = experiment::read_sweep(folder);
    const std::vector<experiment::Cell> cells = experiment::read_cells(folder, sweep);
    const experiment::SweepTables tables = {experiment::centre_table(cells, paper),
                                            experiment::model_table(cells, paper)};
    const std::vector<experiment::ClaimResult> claims =
        experiment::test_claims(experiment::read_run_grid(folder, sweep, paper), paper);
    write_text(folder / "table1.csv", experiment::table1_csv(sweep, tables));
    write_text(folder / "table2.csv", experiment::table2_csv(sweep, tables));
    write_text(folder / "tables.md", experiment::tables_markdown(sweep, tables));
    write_text(folder / "claims.csv", experiment::claims_csv(sweep, claims));
    write_text(folder / "claims.md", experiment::claims_markdown(sweep, claims));
    return 0;
}

} // namespace

void add_summarize(CLI::App &app, Session &session)
{
    CLI::App *command =
        app.add_subcommand("summarize", "Make the paper's tables of a complete sweep and test its claims; writes "
                                        "table1.csv, table2.csv, tables.md, claims.csv, claims.md");
    const auto options = std::make_shared<SummarizeOptions>();
    command->add_option("DIR", options->sweep_dir, "Folder of the sweep, with sweep.json")->required()->type_name("");
    command->add_option("--paper", options->paper_dir, "Folder of the paper's tables as CSV")->type_name("DIR");
    command->callback([options, &session] { session.run = [options] { return summarize(*options); }; });
}

} // namespace twiddle::cli
