#include "commands.hpp"
#include "errors.hpp"
#include "executable.hpp"
#include "learned_policy.hpp"
#include "options.hpp"
#include "run_folder.hpp"
#include "run_replay.hpp"

#include <iostream>
#include <memory>
#include <stdexcept>

namespace twiddle::cli
{

namespace
{

struct ReplayOptions {
    std::string run_dir;
    std::string out;
    std::string stepper; // empty: the run's own
    std::string models_dir;
};

// What was trained, with the physics to replay it in.
record::RunSpecification with_stepper(record::RunSpecification specification, const std::string &stepper)
{
    if (!stepper.empty()) specification.stepper = stepper;
    return specification;
}

// A run's own trajectory is that of its own stepper.
void require_elsewhere(const ReplayOptions &options, const RunFolder &folder)
{
    if (!options.stepper.empty() &&
        std::filesystem::weakly_canonical(options.out) == std::filesystem::weakly_canonical(folder.trajectory_csv()))
        throw UsageError("--out " + options.out +
                         " is the run's own trajectory, which --stepper would replace; name another file");
}

int replay(const ReplayOptions &options, const std::vector<std::string> &arguments)
{
    const RunFolder folder{options.run_dir};
    record::Run run = run_in(folder);
    const record::RunSpecification specification = with_stepper(run.specification, options.stepper);
    require_supported(specification);
    require_elsewhere(options, folder);
    hand_over(specification.number, arguments);

    const std::filesystem::path models = models_dir(options.models_dir);
    const experiment::Trajectory trajectory = replay_policy(folder, specification, models);
    if (!trajectory.result.fault.empty()) throw std::runtime_error(trajectory.result.fault);

    const std::filesystem::path path =
        options.out.empty() ? folder.trajectory_csv() : std::filesystem::path(options.out);
    write_replay(path, specification, trajectory, models);
    if (options.out.empty()) {
        run.replay = replay_entry(trajectory);
        record::write_run(folder.run_json(), run);
    }
    std::cout << "rotation of the learned policy: " << trajectory.result.rotation_rad << " rad\n"
              << "written: " << path.string() << " and " << outline_beside(path).string() << '\n';
    return 0;
}

} // namespace

void add_replay(CLI::App &app, Session &session)
{
    CLI::App *command = app.add_subcommand("replay", "Run the learned policy without noise; writes trajectory.csv");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("RUN_DIR", options->run_dir, "Folder of a complete run")->required()->type_name("");
    CLI::Option *out =
        command->add_option("--out", options->out, "File to write [RUN_DIR/trajectory.csv]")->type_name("FILE");
    command->add_option("--stepper", options->stepper, "Physics other than the run's own; needs --out")
        ->type_name("NAME")
        ->needs(out);
    add_models_option(*command, options->models_dir);
    command->callback(
        [options, &session] { session.run = [options, &session] { return replay(*options, session.arguments); }; });
}

} // namespace twiddle::cli
