#include "commands.hpp"
#include "errors.hpp"
#include "executable.hpp"
#include "experiment/outline.hpp"
#include "experiment/training.hpp"
#include "experiment/trajectory.hpp"
#include "options.hpp"
#include "record/number_text.hpp"
#include "record/policy_json.hpp"
#include "record/versions.hpp"
#include "run_folder.hpp"

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
        parameters.push_back(static_cast<twd_num>(policy.parameters[i].second));
    }
    return parameters;
}

std::vector<std::string> head_comments(const record::RunSpecification &specification, const std::string &what,
                                       const std::vector<std::string> &facts)
{
    std::vector<std::string> comments = {what,
                                         "model: " + specification.model +
                                             (specification.centre ? ", with centre" : ", without centre") +
                                             ", set-up: " + specification.setup,
                                         "units as in the column names; positions in the palm frame"};
    comments.insert(comments.end(), facts.begin(), facts.end());
    comments.push_back("seed: " + std::to_string(specification.seed));
    comments.push_back(record::version_line() + ", number type " + specification.number);
    return comments;
}

void write_files(const std::filesystem::path &path, const record::RunSpecification &specification,
                 const experiment::Trajectory &trajectory, const std::filesystem::path &models)
{
    const sim::ObjectSpec object = sim::read_object(models, specification.object);
    const sim::Setup setup =
        sim::setup_from_settings(specification.settings, specification.setup, "the run's settings");
    const sim::ObjectBody body = sim::object_body(object, setup.object);
    std::vector<std::string> facts = experiment::object_facts(object.name, object.size_m, body);
    experiment::write_outline(outline_beside(path), experiment::object_outline(body),
                              head_comments(specification, "the object's outline at the trial's start", facts));

    facts.push_back("rotation_rad: " + record::number_text(trajectory.result.rotation_rad));
    facts.push_back("min_finger_clearance_m: " + record::number_text(trajectory.min_finger_clearance_m));
    experiment::write_trajectory(
        path, trajectory,
        head_comments(specification, "one trial of the learned policy without noise; a row is the end of a 10 ms step",
                      facts));
}

int replay(const ReplayOptions &options, const std::vector<std::string> &arguments)
{
    const RunFolder folder{options.run_dir};
    if (!std::filesystem::exists(folder.run_json()))
        throw UsageError("'" + options.run_dir + "' is no folder of a run: it holds no run.json");
    record::Run run = record::read_run(folder.run_json());
    require_supported(run.specification);
    hand_over(run.specification.number, arguments);

    const std::filesystem::path models = models_dir(options.models_dir);
    const experiment::Parameters parameters = learned_parameters(folder, run.specification);
    experiment::TrialRunner runner = experiment::make_trial_runner(run.specification, models);
    const experiment::Trajectory trajectory = experiment::record_trajectory(runner, parameters);
    if (!trajectory.result.fault.empty()) throw std::runtime_error(trajectory.result.fault);

    const std::filesystem::path path =
        options.out.empty() ? folder.trajectory_csv() : std::filesystem::path(options.out);
    write_files(path, run.specification, trajectory, models);
    if (options.out.empty()) {
        run.replay = {{"rotation_rad", trajectory.result.rotation_rad},
                      {"min_finger_clearance_m", trajectory.min_finger_clearance_m}};
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
