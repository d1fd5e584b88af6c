#include "choices.hpp"
#include "commands.hpp"
#include "runs/learned_policy.hpp"
#include "runs/run_folder.hpp"
#include "runs/run_replay.hpp"
#include "runs/usage_error.hpp"

#include <iostream>
#include <stdexcept>

namespace twiddle::cli
{

namespace
{

// What was trained, with the physics to replay it in.
record::RunSpecification with_stepper(record::RunSpecification specification, const std::string &stepper)
{
    if (!stepper.empty()) specification.stepper = stepper;
    return specification;
}

// A run's own trajectory is that of its own stepper.
void require_elsewhere(const ReplayOptions &options, const runs::RunFolder &folder)
{
    if (!options.stepper.empty() &&
        std::filesystem::weakly_canonical(options.out) == std::filesystem::weakly_canonical(folder.trajectory_csv()))
        throw runs::UsageError("--out " + options.out +
                               " is the run's own trajectory, which --stepper would replace; name another file");
}

} // namespace

int run_command(const ReplayOptions &options, const Arguments & /*arguments*/)
{
    const runs::RunFolder folder{options.run_dir};
    record::Run run = runs::run_in(folder);
    const record::RunSpecification specification = with_stepper(run.specification, options.stepper);
    require_supported(specification);
    require_elsewhere(options, folder);

    const std::filesystem::path models = models_dir(options.models_dir);
    const experiment::Trajectory trajectory = runs::replay_policy(folder, specification, models);
    if (!trajectory.result.fault.empty()) throw std::runtime_error(trajectory.result.fault);

    const std::filesystem::path path =
        options.out.empty() ? folder.trajectory_csv() : std::filesystem::path(options.out);
    runs::write_replay(path, specification, trajectory, models);
    if (options.out.empty()) {
        run.replay = runs::replay_entry(trajectory);
        record::write_run(folder.run_json(), run);
    }
    std::cout << "rotation of the learned policy: " << trajectory.result.rotation_rad << " rad\n"
              << "written: " << path.string() << " and " << runs::outline_beside(path).string() << '\n';
    return 0;
}

} // namespace twiddle::cli
