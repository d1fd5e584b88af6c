#include "commands.hpp"
#include "errors.hpp"
#include "executable.hpp"
#include "options.hpp"
#include "run_folder.hpp"
#include "training_session.hpp"

#include <iostream>
#include <limits>
#include <memory>

namespace twiddle::cli
{

namespace
{

constexpr std::uint64_t most_trials = 10'000'000;

struct TrainOptions {
    RunOptions run;
    std::string seed = "1";
    std::string trials = "5000";
    std::string out;
    bool resume = false;
};

int train(const TrainOptions &options, const std::vector<std::string> &arguments)
{
    require_supported(options.run);
    hand_over(options.run.number, arguments);

    const auto seed = whole_number("--seed", options.seed, 0, std::numeric_limits<std::uint64_t>::max());
    const auto trials = static_cast<std::uint32_t>(whole_number("--trials", options.trials, 1, most_trials));
    const std::filesystem::path models = models_dir(options.run.models_dir);
    record::Run run;
    run.specification = run_specification(options.run, models, seed, trials);
    run.command = shell_line(arguments);

    const RunFolder folder{options.out.empty() ? default_run_path(run.specification)
                                               : std::filesystem::path(options.out)};
    const std::optional<record::Run> earlier = claim(folder, run.specification);
    if (options.resume && earlier && earlier->complete) {
        std::cout << "the run in " << folder.path.string() << " is already complete\n";
        return 0;
    }
    TrainingSession session(folder, run, models);
    return session.run(options.resume && earlier);
}

} // namespace

void add_train(CLI::App &app, Session &session)
{
    CLI::App *command = app.add_subcommand("train", "Learn one skill; writes run.json, trials.csv and policy.json");
    const auto options = std::make_shared<TrainOptions>();
    add_run_options(*command, options->run);
    command->add_option("--seed", options->seed, "Seed of weights and noise")->type_name("N")->capture_default_str();
    command->add_option("--trials", options->trials, "Length of the training")->type_name("N")->capture_default_str();
    command->add_option("--out", options->out, "Folder of the run [results/OBJECT/MODEL[-no-centre]/seed-N]")
        ->type_name("DIR");
    command->add_flag("--resume", options->resume, "Go on with a run that was interrupted");
    command->callback(
        [options, &session] { session.run = [options, &session] { return train(*options, session.arguments); }; });
}

} // namespace twiddle::cli
