// The one source that knows CLI11: all options of all commands.
#include "command_line.hpp"

#include "choices.hpp"
#include "record/versions.hpp"
#include "runs/usage_error.hpp"

#include <CLI/CLI.hpp>

namespace twiddle::cli
{

namespace
{

void add_models(CLI::App &command, std::string &models_dir)
{
    command.add_option("--models", models_dir, "Folder of hand, objects and set-ups")->type_name("DIR");
}

CLI::Option *add_number(CLI::App &command, std::string &number)
{
    return command.add_option("--number", number, "Number type of the C library: float, double or fixed")
        ->type_name("TYPE")
        ->capture_default_str();
}

void add_run(CLI::App &command, RunOptions &options)
{
    command.add_option("--object", options.object, "{small,medium,large}-{sphere,cylinder,cube}")
        ->required()
        ->type_name("NAME");
    command.add_option("--model", options.model, "cpg-s, cpg-m, cpg-c or cpg-h")->required()->type_name("NAME");
    command.add_flag("--no-centre", options.no_centre, "Oscillators without a centre parameter");
    command.add_option("--setup", options.setup, "Physical and learning set-up, or a .toml file")
        ->type_name("NAME")
        ->capture_default_str();
    command.add_option("--set", options.overrides, "Override one setting; may be repeated")
        ->type_name("section.key=value")
        ->allow_extra_args(false);
    command.add_option("--stepper", options.stepper, "Physics")->type_name("NAME")->capture_default_str();
    command.add_option("--hand", options.hand, "welded, or full: all 19 joints movable")
        ->type_name("NAME")
        ->capture_default_str();
    add_number(command, options.number)->each([&options](const std::string &) { options.number_given = true; });
    command.add_option("--target", options.target, "Where the C library runs: " + comma_list(targets()))
        ->type_name("NAME")
        ->capture_default_str();
    add_models(command, options.models_dir);
}

void add_options(CLI::App &command, TrainOptions &options)
{
    add_run(command, options.run);
    command.add_option("--port", options.port.port, "Serial port of the board where the C library runs")
        ->type_name("PATH")
        ->excludes("--target");
    command.add_option("--baud", options.port.baud, "Speed of --port, bit/s")->type_name("N")->capture_default_str();
    command.add_option("--seed", options.seed, "Seed of weights and noise")->type_name("N")->capture_default_str();
    command.add_option("--trials", options.trials, "Length of the training")->type_name("N")->capture_default_str();
    command.add_option("--out", options.out, "Folder of the run [results/OBJECT/MODEL[-no-centre]/seed-N]")
        ->type_name("DIR");
    command.add_flag("--resume", options.resume, "Go on with a run that was interrupted");
}

void add_options(CLI::App &command, SweepOptions &options)
{
    command.add_option("MANIFEST", options.manifest, "A .toml file as those in experiments/sweeps")->required();
    command.add_option("--out", options.out, "Folder of the sweep")->required()->type_name("DIR");
    command.add_option("--jobs", options.jobs, "Runs at a time [one a processor]")->type_name("N");
    command.add_option("--only", options.only, "Do one run alone, by its index in sweep.json")->type_name("INDEX");
    command.add_flag("--list-missing", options.list_missing,
                     "Make the folder, print the index of each run that is not complete, and train none");
    command
        .add_option("--setup", options.setup,
                    "Physical and learning set-up, or a .toml file, whatever the manifest says")
        ->type_name("NAME");
    add_number(command, options.number);
    add_models(command, options.models_dir);
}

void add_options(CLI::App &command, CalibrateOptions &options)
{
    command.add_option("PLAN", options.plan, "A .toml file as those in experiments/calibrations")->required();
    command.add_option("--out", options.out, "Folder to write to")->required()->type_name("DIR");
    command.add_option("--jobs", options.jobs, "Runs at a time [one a processor]")->type_name("N");
    command.add_option("--paper", options.paper_dir, "Folder of the paper's tables as CSV")->type_name("DIR");
    add_number(command, options.number);
    add_models(command, options.models_dir);
}

void add_options(CLI::App &command, ReplayOptions &options)
{
    command.add_option("RUN_DIR", options.run_dir, "Folder of a complete run")->required()->type_name("");
    CLI::Option *out =
        command.add_option("--out", options.out, "File to write [RUN_DIR/trajectory.csv]")->type_name("FILE");
    command.add_option("--stepper", options.stepper, "Physics other than the run's own; needs --out")
        ->type_name("NAME")
        ->needs(out);
    add_models(command, options.models_dir);
}

void add_options(CLI::App &command, RolloutOptions &options)
{
    add_run(command, options.run);
}

void add_options(CLI::App &command, ExportOptions &options)
{
    command.add_option("RUN_DIR", options.run_dir, "Folder of a complete run")->required()->type_name("");
    command.add_flag("--c-header", options.c_header, "As constants in C99, for any number build")->required();
    command.add_option("--name", options.name, "What the header's names begin with [OBJECT_MODEL]")->type_name("NAME");
    command.add_option("--out", options.out, "File to write [standard output]")->type_name("FILE");
    add_models(command, options.models_dir);
}

void add_options(CLI::App &command, SummarizeOptions &options)
{
    command.add_option("DIR", options.sweep_dir, "Folder of the sweep, with sweep.json")->required()->type_name("");
    command.add_option("--paper", options.paper_dir, "Folder of the paper's tables as CSV")->type_name("DIR");
    add_models(command, options.models_dir);
}

void add_options(CLI::App &command, CompareClaimsOptions &options)
{
    command.add_option("DIR", options.sweep_dirs, "Folders of sweeps, with claims.csv")->required()->type_name("");
}

void add_options(CLI::App &command, ViewOptions &options)
{
    command.add_option("DIR", options.dir, "Folder of a run with a replay, or of a sweep, with sweep.json")
        ->required()
        ->type_name("");
    CLI::Option *out = command.add_option("--out", options.out, "File to write [DIR/replay.html]")->type_name("FILE");
    CLI::Option *compare =
        command.add_option("--compare", options.compare, "Folder of a second run, to be shown beside")
            ->type_name("DIR");
    command.add_flag("--index-only", options.index_only, "Of a sweep: its index without the runs' pages")
        ->excludes(out)
        ->excludes(compare);
    add_models(command, options.models_dir);
}

void add_options(CLI::App &command, InfoOptions &options)
{
    add_models(command, options.models_dir);
}

// The command `name`, whose options become `asked` when it is the one that was given.
template <class Options>
void add_command(CLI::App &app, std::optional<Command> &asked, const std::string &name, const std::string &help)
{
    CLI::App *command = app.add_subcommand(name, help);
    const auto options = std::make_shared<Options>();
    add_options(*command, *options);
    command->callback([options, &asked] { asked = *options; });
}

void add_commands(CLI::App &app, std::optional<Command> &asked)
{
    add_command<TrainOptions>(app, asked, "train", "Learn one skill; writes run.json, trials.csv and policy.json");
    add_command<SweepOptions>(
        app, asked, "sweep", "Learn many skills, as a manifest lists them; goes on where an earlier start was stopped");
    add_command<CalibrateOptions>(
        app, asked, "calibrate",
        "Search a set-up that comes near the paper's tables; writes candidates.csv, setup-1.toml, ...");
    add_command<ReplayOptions>(app, asked, "replay", "Run the learned policy without noise; writes trajectory.csv");
    add_command<RolloutOptions>(app, asked, "rollout",
                                "Read parameter vectors, one CSV line each; write one rotation in rad a line");
    add_command<ExportOptions>(app, asked, "export", "Write what a run has learned for firmware, as a C header");
    add_command<SummarizeOptions>(
        app, asked, "summarize",
        "Make the paper's tables of a complete sweep, test its claims, and make its figures' data; writes "
        "table1.csv, table2.csv, tables.md, claims.csv, claims.md, distance.csv, distance.md, figures/data; of a "
        "sweep with variants also choices.csv, choices.md");
    add_command<CompareClaimsOptions>(
        app, asked, "compare-claims",
        "Put the claims of several summarized sweeps side by side, as Markdown on standard output");
    add_command<ViewOptions>(app, asked, "view",
                             "Write a page on which a browser replays a run; of a sweep, one a run and index.html");
    add_command<InfoOptions>(app, asked, "info", "Print versions, number type, models, objects and set-ups");
}

} // namespace

std::optional<Command> parse_command_line(int argc, char **argv)
{
    std::optional<Command> asked;
    CLI::App app("Rhythmic hand skills, learned by trial and error.", "twiddle");
    app.set_version_flag("--version", record::version_line());
    add_commands(app, asked);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success &answered) { // --help and --version
        app.exit(answered);
        return std::nullopt;
    } catch (const CLI::ParseError &error) {
        throw runs::UsageError(std::string(error.what()) + "; see --help");
    }
    if (!asked)
        throw runs::UsageError("a command is missing: train, sweep, calibrate, replay, rollout, export, summarize, "
                               "compare-claims, view or info; see --help");
    return asked;
}

} // namespace twiddle::cli
