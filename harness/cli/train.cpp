#include "choices.hpp"
#include "commands.hpp"
#include "link/connection.hpp"
#include "own_program.hpp"
#include "record/progress.hpp"
#include "runs/run_folder.hpp"
#include "runs/stop_request.hpp"
#include "runs/training_session.hpp"
#include "runs/usage_error.hpp"
#include "target.hpp"

#include <chrono>
#include <iostream>
#include <limits>

#include <unistd.h>

namespace twiddle::cli
{

namespace
{

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Run the session's trials to the end, or until Ctrl-C, and report each. Returns whether the end was reached.
bool run_trials(runs::TrainingSession &session, std::uint32_t trials)
{
    record::Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1, trials, session.trials_done());
    for (const double reward : session.rewards()) {
        progress.recall(reward);
    }
    const auto start = std::chrono::steady_clock::now();
    while (!session.is_done()) {
        const experiment::TrialRow row = session.run_trial();
        progress.update(row.reward, seconds_since(start));
        if (!row.fault.empty()) {
            progress.end_line();
            std::cerr << "twiddle: trial " << row.trial << ": " << row.fault << '\n';
        }
        if (runs::stop_signal() != 0 && !session.is_done()) {
            progress.end_line();
            return false;
        }
    }
    return true;
}

void print(const record::TrainingSummary &summary, const runs::RunFolder &folder)
{
    std::cout << "mean rotation of the first " << summary.first_trials
              << " trials: " << summary.mean_rotation_of_first_rad << " rad\n"
              << "mean rotation of the last " << summary.last_trials << " trials: " << summary.mean_rotation_of_last_rad
              << " rad\n";
    if (summary.faults > 0) std::cout << "trials with a fault, counted as 0 rad: " << summary.faults << '\n';
    std::cout << "run.json, trials.csv and policy.json are in " << folder.path.string() << '\n';
}

// Train to the end, or until Ctrl-C; returns the program's status.
int train(runs::TrainingSession &session, const std::optional<record::Run> &earlier, const runs::RunFolder &folder,
          std::uint32_t trials)
{
    if (earlier) {
        session.resume("train again without --resume");
    } else {
        session.start_anew();
    }
    if (!run_trials(session, trials)) {
        std::cerr << "twiddle: stopped after trial " << session.trials_done() << " of " << trials
                  << "; the same command with --resume goes on\n";
        return 128 + runs::stop_signal(); // as a shell reports it
    }
    print(session.finish(), folder);
    return 0;
}

} // namespace

int run_command(const TrainOptions &options, const Arguments &arguments)
{
    require_supported(options.run);
    const Target target = target_of(options.run, options.port);

    const auto seed = whole_number("--seed", options.seed, 0, std::numeric_limits<std::uint64_t>::max());
    const auto trials =
        static_cast<std::uint32_t>(whole_number("--trials", options.trials, 1, experiment::most_trials));
    const std::filesystem::path models = models_dir(options.run.models_dir);
    record::Run run;
    run.specification = run_specification(options.run, models, seed, trials);
    run.specification.number = target.number;
    run.command = shell_line(arguments);
    run.target = target.name;
    run.port = target.port;

    const runs::RunFolder folder{options.out.empty() ? runs::default_run_path(run.specification)
                                                     : std::filesystem::path(options.out)};
    const std::optional<record::Run> earlier = runs::claim(folder, run.specification, "choose another folder by --out");
    if (options.resume && earlier && earlier->complete) {
        std::cout << "the run in " << folder.path.string() << " is already complete\n";
        return 0;
    }
    runs::TrainingSession session(folder, run, models, agent_maker(target));
    runs::catch_stop_signals();
    try {
        return train(session, options.resume ? earlier : std::nullopt, folder, trials);
    } catch (const link::LinkError &error) {
        throw std::runtime_error(std::string(error.what()) + "; the same command with --resume goes on");
    }
}

} // namespace twiddle::cli
