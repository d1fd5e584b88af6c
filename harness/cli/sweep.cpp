#include "choices.hpp"
#include "commands.hpp"
#include "own_program.hpp"
#include "runs/stop_request.hpp"
#include "runs/usage_error.hpp"
#include "sweeps/sweep_folder.hpp"
#include "sweeps/sweep_manifest.hpp"
#include "sweeps/sweep_session.hpp"

#include <iostream>
#include <numeric>
#include <stdexcept>

namespace twiddle::cli
{

namespace
{

sweeps::SweepPlan read_plan(const SweepOptions &options, const std::filesystem::path &models)
{
    if (!options.setup.empty()) require_setup(models, options.setup);
    const RunOptions silent;
    record::RunSpecification defaults;
    defaults.setup = silent.setup;
    defaults.stepper = silent.stepper;
    defaults.hand = silent.hand;
    defaults.number = options.number;
    try {
        return sweeps::read_sweep_manifest(options.manifest, {models, setups_dir(models)}, defaults, options.setup);
    } catch (const std::runtime_error &error) {
        throw runs::UsageError(error.what()); // the manifest is the user's choice
    }
}

// The command that does run `index` alone.
std::string command_of(const std::string &program, const SweepOptions &options, std::size_t index)
{
    std::vector<std::string> arguments = {program,     "sweep",  options.manifest,     "--out",
                                          options.out, "--only", std::to_string(index)};
    if (!options.setup.empty()) arguments.insert(arguments.end(), {"--setup", options.setup});
    if (options.number != SweepOptions().number) arguments.insert(arguments.end(), {"--number", options.number});
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

int conclude(const sweeps::SweepOutcome &outcome, std::size_t runs, const std::string &out)
{
    if (runs::stop_signal() != 0 && outcome.complete + outcome.failed < runs) {
        const std::string failed =
            outcome.failed > 0 ? ", " + std::to_string(outcome.failed) + " failed (" + outcome.first_failure + ")" : "";
        std::cerr << "twiddle: stopped with " << counted(outcome.complete, runs) << " complete" << failed
                  << "; the same command goes on\n";
        return 128 + runs::stop_signal(); // as a shell reports it
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
int print_missing(const sweeps::SweepSession &session, const std::vector<std::size_t> &chosen)
{
    for (const std::size_t index : session.missing(chosen)) {
        std::cout << index << '\n';
    }
    return 0;
}

} // namespace

int run_command(const SweepOptions &options, const Arguments &arguments)
{
    require_number(options.number);
    const std::size_t jobs = jobs_at_a_time(options.jobs);
    const std::filesystem::path models = models_dir(options.models_dir);
    const sweeps::SweepPlan plan = read_plan(options, models);
    const std::vector<std::size_t> chosen = chosen_runs(options, plan.runs.size());
    sweeps::claim_sweep(options.out, plan);
    sweeps::SweepSession session(plan, options.out, models,
                                 [&](std::size_t index) { return command_of(arguments.front(), options, index); });
    if (options.list_missing) return print_missing(session, chosen);
    return conclude(session.run(chosen, jobs), chosen.size(), options.out);
}

} // namespace twiddle::cli
