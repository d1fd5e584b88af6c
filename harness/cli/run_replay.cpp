#include "run_replay.hpp"

#include "errors.hpp"
#include "experiment/outline.hpp"
#include "experiment/training.hpp"
#include "record/number_text.hpp"
#include "record/policy_json.hpp"
#include "record/versions.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace twiddle::cli
{

namespace
{

experiment::Parameters learned_parameters(const RunFolder &folder, const record::RunSpecification &specification)
{
    if (!std::filesystem::exists(folder.policy_json()))
        throw UsageError("'" + folder.path.string() +
                         "' holds no policy.json: its training is not complete; finish it by train --resume");
    const record::Policy policy = record::read_policy(folder.policy_json());
    const std::vector<std::string> names =
        experiment::parameter_names(experiment::find_model(specification.model), specification.centre);
    const std::string sentence = "'" + folder.policy_json().string() + "': 'parameters' must be those of " +
                                 specification.model + (specification.centre ? "" : " without centre") + ", in order";
    if (policy.parameters.size() != names.size()) throw std::runtime_error(sentence);

    experiment::Parameters parameters;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (policy.parameters[i].first != names[i]) throw std::runtime_error(sentence);
        parameters.push_back(twd_num_from_double(policy.parameters[i].second));
    }
    return parameters;
}

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
    const experiment::Parameters parameters = learned_parameters(folder, specification);
    experiment::TrialRunner runner = experiment::make_trial_runner(specification, models);
    return experiment::record_trajectory(runner, parameters);
}

void write_replay(const std::filesystem::path &path, const record::RunSpecification &specification,
                  const experiment::Trajectory &trajectory, const std::filesystem::path &models)
{
    const sim::ObjectSpec object = sim::read_object(models, specification.object);
    const sim::Setup setup =
        sim::setup_from_settings(specification.settings, specification.setup, "the run's settings");
    const sim::ObjectBody body = sim::object_body(object, setup.object);
    std::vector<std::string> facts = experiment::object_facts(object.name, object.size_m, body);
    experiment::write_outline(outline_beside(path), experiment::object_outline(body),
                              head_comments(specification, "the object's outline at the trial's start", facts));

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

record::Json replay_entry(const experiment::Trajectory &trajectory)
{
    if (!trajectory.result.fault.empty()) return {{"fault", trajectory.result.fault}};
    return {{"rotation_rad", trajectory.result.rotation_rad},
            {"min_finger_clearance_m", trajectory.min_finger_clearance_m}};
}

void add_replay_to(const RunFolder &folder, const std::filesystem::path &models)
{
    record::Run run = record::read_run(folder.run_json());
    const experiment::Trajectory trajectory = replay_policy(folder, run.specification, models);
    write_replay(folder.trajectory_csv(), run.specification, trajectory, models);
    run.replay = replay_entry(trajectory);
    record::write_run(folder.run_json(), run);
}

} // namespace twiddle::cli
