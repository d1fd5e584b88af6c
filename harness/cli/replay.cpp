#include "commands.hpp"
#include "errors.hpp"
#include "executable.hpp"
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
    std::string models_dir;
};

int replay(const ReplayOptions &options, const std::vector<std::string> &arguments)
{
    const RunFolder folder{options.run_dir};
    if (!std::filesystem::exists(folder.run_json()))
        throw UsageError("'" + options.run_dir + "' is no folder of a run: it holds no run.json");
    record::Run run = record::read_run(folder.run_json());
    require_supported(run.specification);
    hand_over(run.specification.number, arguments);

    const std::filesystem::path models = models_dir(options.models_dir);
    const experiment::Trajectory trajectory = replay_policy(folder, run.specification, models);
    if (!trajectory.result.fault.empty()) throw std::runtime_error(trajectory.result.fault);

    const std::filesystem::path path =
        options.out.empty() ? folder.trajectory_csv() : std::filesystem::path(options.out);
    write_replay(path, run.specification, trajectory, models);
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
    command->add_option("--out", options->out, "File to write [RUN_DIR/trajectory.csv]")->type_name("FILE");
    add_models_option(*command, options->models_dir);
    command->callback(
        [options, &session] { session.run = [options, &session] { return replay(*options, session.arguments); }; });
}

} // namespace twiddle::cli
