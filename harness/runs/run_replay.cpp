#include "run_replay.hpp"

#include "experiment/outline.hpp"
#include "experiment/training.hpp"
#include "learned_policy.hpp"
#include "record/number_text.hpp"
#include "record/versions.hpp"

#include <string>
#include <vector>

namespace twiddle::runs
{

namespace
{

std::vector<std::string> head_comments(const record::RunSpecification &specification, const std::string &what,
                                       const std::vector<std::string> &facts)
{
    std::vector<std::string> comments = {what,
                                         "model: " + specification.model +
                                             (specification.centre ? ", with centre" : ", without centre") +
                                             ", set-up: " + specification.setup + ", stepper: " + specification.stepper,
                                         "units as in the column names; positions in the palm frame"};
    comments.insert(comments.end(), facts.begin(), facts.end());
    comments.push_back("seed: " + std::to_string(specification.seed));
    comments.push_back(record::version_line() + ", number type " + specification.number);
    return comments;
}

} // namespace

experiment::Trajectory replay_policy(const RunFolder &folder, const record::RunSpecification &specification,
                                     const std::filesystem::path &models)
{
    engine::Parameters parameters;
    for (const auto &[name, value] : learned_policy(folder, specification).parameters) {
        parameters.push_back(value);
    }
    experiment::TrialRunner runner = experiment::make_trial_runner(specification, models);
    return experiment::record_trajectory(runner, parameters);
}

void write_replay(const std::filesystem::path &path, const record::RunSpecification &specification,
                  const experiment::Trajectory &trajectory, const std::filesystem::path &models)
{
    const sim::ObjectSpec object = sim::read_object(models, specification.object);
    const settings::Setup setup =
        settings::setup_from_settings(specification.settings, specification.setup, "the run's settings");
    const sim::ObjectBody body = sim::object_body(object, setup.object);
    std::vector<std::string> facts = experiment::object_facts(object.name, object.size_m, body);
    experiment::write_outline(outline_beside(path), experiment::object_outline(body),
                              head_comments(specification, "the object's outline at the trial's start", facts));

    const std::vector<std::string> fixed = experiment::fixed_facts(setup, body);
    facts.insert(facts.end(), fixed.begin(), fixed.end());
    if (trajectory.result.fault.empty()) {
        facts.push_back("rotation_rad: " + record::number_text(trajectory.result.rotation_rad));
        facts.push_back("min_finger_clearance_m: " + record::number_text(trajectory.min_finger_clearance_m));
    } else {
        facts.push_back("fault: " + trajectory.result.fault);
    }
    experiment::write_trajectory(
        path, trajectory,
        head_comments(specification, "one trial of the learned policy without noise; a row is the end of a 10 ms step",
                      facts));
}

record::ReplaySummary replay_entry(const experiment::Trajectory &trajectory)
{
    return {trajectory.result.rotation_rad, trajectory.min_finger_clearance_m, trajectory.result.fault};
}

void add_replay_to(const RunFolder &folder, const std::filesystem::path &models)
{
    record::Run run = record::read_run(folder.run_json());
    const experiment::Trajectory trajectory = replay_policy(folder, run.specification, models);
    write_replay(folder.trajectory_csv(), run.specification, trajectory, models);
    run.replay = replay_entry(trajectory);
    record::write_run(folder.run_json(), run);
}

} // namespace twiddle::runs
