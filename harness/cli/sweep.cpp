#include "commands.hpp"
#include "errors.hpp"
#include "executable.hpp"
#include "experiment/sweep_manifest.hpp"
#include "options.hpp"
#include "stop_request.hpp"
#include "sweep_folder.hpp"
#include "sweep_session.hpp"

#include <iostream>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace twiddle::cli
{

namespace
{

struct SweepOptions {
    std::string manifest;
    std::string out;
    std::string jobs;
    std::string only;
    std::string setup; // instead of the manifest's; empty: the manifest's
    std::string models_dir;
    bool list_missing = false;
};

experiment::SweepPlan read_plan(const SweepOptions &options, const std::filesystem::path &models)
{
    if (!options.setup.empty()) require_setup(models, options.setup);
    const RunOptions silent;
    record::RunSpecification defaults;
    defaults.setup = silent.setup;
    defaults.stepper = silent.stepper;
    defaults.hand = silent.hand;
    defaults.number = own_number();
    try {
        return experiment::read_sweep_manifest(options.manifest, models, defaults, options.setup);
    } catch (const std::runtime_error &error) {
        throw UsageError(error.what()); // the manifest is the user's choice
    }
}

// The command that does run `index` alone.
std::string command_of(const std::string &program, const SweepOptions &options, std::size_t index)
{
    std::vector<std::string> arguments = {program,     "sweep",  options.manifest,     "--out",
                                          options.out, "--only", std::to_string(index)};
    if (!options.setup.empty()) arguments.insert(arguments.end(), {"--setup", options.setup});
    if (!options.models_dir.empty()) arguments.insert(arguments.end(), {"--models", options.models_dir});
    return shell_line(arguments);
}

// The runs to do, by their index.
std::vector<std::size_t> chosen_runs(const SweepOptions &options, std::size_t runs)
{
    if (!options.only.empty()) return {static_cast<std::size_t>(whole_number("--only", options.only, 0, runs - 1))};
    std::vector<std::size_t> all(runs);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

std::string counted(std::size_t number, std::size_t all)
{
    return std::to_string(number) + " of " + std::to_string(all) + (all == 1 ? " run" : " runs");
}

int conclude(const SweepOutcome &outcome, std::size_t runs, const std::string &out)
{
    if (stop_signal() != 0 && outcome.complete + outcome.failed < runs) {
        const std::string failed =
            outcome.failed > 0 ? ", " + std::to_string(outcome.failed) + " failed (" + outcome.first_failure + ")" : "";
        std::cerr << "twiddle: stopped with " << counted(outcome.complete, runs) << " complete" << failed
                  << "; the same command goes on\n";
        return 128 + stop_signal(); // as a shell reports it
    }
    if (outcome.failed > 0)
        throw std::runtime_error(counted(outcome.failed, runs) + " failed; the first: " + outcome.first_failure);
    if (outcome.complete < runs)
        throw std::runtime_error(counted(outcome.complete, runs) + " complete, the others were stopped");
    std::cout << counted(runs, runs) << (runs == 1 ? " is" : " are") << " complete in " << out;
    if (outcome.kept > 0) std::cout << ", " << outcome.kept << (outcome.kept == 1 ? " was" : " were") << " before";
    std::cout << '\n';
    return 0;
}

// One index a line, for programs that start the runs themselves.
int print_missing(const SweepSession &session, const std::vector<std::size_t> &chosen)
{
    for (const std::size_t index : session.missing(chosen)) {
        std::cout << index << '\n';
    }
    return 0;
}

int sweep(const SweepOptions &options, const std::vector<std::string> &arguments)
{
    const std::size_t jobs = jobs_at_a_time(options.jobs);
    const std::filesystem::path models = models_dir(options.models_dir);
    const experiment::SweepPlan plan = read_plan(options, models);
    const std::vector<std::size_t> chosen = chosen_runs(options, plan.runs.size());
    claim_sweep(options.out, experiment::sweep_json(plan));
    SweepSession session(plan, options.out, models,
                         [&](std::size_t index) { return command_of(arguments.front(), options, index); });
    if (options.list_missing) return print_missing(session, chosen);
    return conclude(session.run(chosen, jobs), chosen.size(), options.out);
}

} // namespace

void add_sweep(CLI::App &app, Session &session)
{
    CLI::App *command = app.add_subcommand(
        "sweep", "Learn many skills, as a manifest lists them; goes on where an earlier start was stopped");
    const auto options = std::make_shared<SweepOptions>();
    command->add_option("MANIFEST", options->manifest, "A .toml file as those in models/sweeps")->required();
    command->add_option("--out", options->out, "Folder of the sweep")->required()->type_name("DIR");
    command->add_option("--jobs", options->jobs, "Runs at a time [one a processor]")->type_name("N");
    command->add_option("--only", options->only, "Do one run alone, by its index in sweep.json")->type_name("INDEX");
    command->add_flag("--list-missing", options->list_missing,
                      "Make the folder, print the index of each run that is not complete, and train none");
    command
        ->add_option("--setup", options->setup,
                     "Physical and learning set-up, or a .toml file, whatever the manifest says")
        ->type_name("NAME");
    add_models_option(*command, options->models_dir);
    command->callback(
        [options, &session] { session.run = [options, &session] { return sweep(*options, session.arguments); }; });
}

} // namespace twiddle::cli
