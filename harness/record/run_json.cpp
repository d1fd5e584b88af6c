#include "run_json.hpp"

#include "json_file.hpp"
#include "versions.hpp"

#include <tuple>

namespace twiddle::record
{

namespace
{

auto plain_fields(const RunSpecification &s)
{
    return std::tie(s.object, s.model, s.centre, s.seed, s.trials, s.hand, s.stepper, s.number, s.setup);
}

// Keys sorted, whatever their order in the text.
nlohmann::json settings_of(const RunSpecification &specification)
{
    return nlohmann::json::parse(specification.settings);
}

RunSpecification read_specification(const Json &json, const std::filesystem::path &path)
{
    RunSpecification specification;
    const auto text = [&](const char *key) { return json_value<std::string>(json, key, "a text", path); };
    specification.object = text("object");
    specification.model = text("model");
    specification.centre = json_value<bool>(json, "centre", "true or false", path);
    specification.seed = json_value<std::uint64_t>(json, "seed", "a whole number", path);
    specification.trials = json_value<std::uint32_t>(json, "trials", "a whole number", path);
    specification.hand = text("hand");
    specification.stepper = text("stepper");
    specification.number = text("number");
    specification.setup = text("setup");
    specification.settings = json_value<nlohmann::json>(json, "settings", "an object of settings", path).dump();
    return specification;
}

Json summary_json(const TrainingSummary &summary)
{
    return {{"first_trials", summary.first_trials},
            {"mean_rotation_of_first_rad", summary.mean_rotation_of_first_rad},
            {"last_trials", summary.last_trials},
            {"mean_rotation_of_last_rad", summary.mean_rotation_of_last_rad},
            {"faults", summary.faults}};
}

TrainingSummary read_summary(const Json &json, const std::filesystem::path &path)
{
    const auto count = [&](const char *key) { return json_value<std::size_t>(json, key, "a whole number", path); };
    const auto number = [&](const char *key) { return json_value<double>(json, key, "a number", path); };
    return {count("first_trials"), number("mean_rotation_of_first_rad"), count("last_trials"),
            number("mean_rotation_of_last_rad"), count("faults")};
}

Json replay_json(const ReplaySummary &replay)
{
    if (!replay.fault.empty()) return {{"fault", replay.fault}};
    return {{"rotation_rad", replay.rotation_rad}, {"min_finger_clearance_m", replay.min_finger_clearance_m}};
}

ReplaySummary read_replay(const Json &json, const std::filesystem::path &path)
{
    if (json.contains("fault")) return {0, 0, json_value<std::string>(json, "fault", "a text", path)};
    const auto number = [&](const char *key) { return json_value<double>(json, key, "a number", path); };
    return {number("rotation_rad"), number("min_finger_clearance_m"), {}};
}

} // namespace

bool operator==(const RunSpecification &a, const RunSpecification &b)
{
    // A whole number counts as the same with or without its ".0".
    return plain_fields(a) == plain_fields(b) && (a.settings == b.settings || settings_of(a) == settings_of(b));
}

bool operator!=(const RunSpecification &a, const RunSpecification &b)
{
    return !(a == b);
}

std::filesystem::path folder_of(const RunSpecification &specification)
{
    const std::string model = specification.model + (specification.centre ? "" : "-no-centre");
    return std::filesystem::path(specification.object) / model / ("seed-" + std::to_string(specification.seed));
}

void write_run(const std::filesystem::path &path, const Run &run)
{
    const RunSpecification &specification = run.specification;
    Json json;
    json["what"] = "a training run of twiddle";
    json["state"] = run.complete ? "complete" : "running";
    json["object"] = specification.object;
    json["model"] = specification.model;
    json["centre"] = specification.centre;
    json["seed"] = specification.seed;
    json["trials"] = specification.trials;
    json["hand"] = specification.hand;
    json["stepper"] = specification.stepper;
    json["number"] = specification.number;
    json["target"] = run.target;
    if (!run.port.empty()) json["port"] = run.port;
    json["command"] = run.command;
    json["versions"] = {
        {"twiddle", version()}, {"git_commit", git_commit()}, {"bullet", bullet_version()}, {"compiler", compiler()}};
    if (run.summary) json["summary"] = summary_json(*run.summary);
    if (run.replay) json["replay"] = replay_json(*run.replay);
    json["setup"] = specification.setup;
    json["settings"] = settings_of(specification);
    write_json(path, json);
}

Run read_run(const std::filesystem::path &path)
{
    const Json json = read_json(path);
    Run run;
    run.specification = read_specification(json, path);
    const auto state = json_value<std::string>(json, "state", "\"running\" or \"complete\"", path);
    if (state != "running" && state != "complete")
        throw std::runtime_error("'" + path.string() + "': 'state' must be \"running\" or \"complete\"");
    run.complete = state == "complete";
    run.command = json_value<std::string>(json, "command", "a text", path);
    if (json.contains("target")) run.target = json_value<std::string>(json, "target", "a text", path);
    if (json.contains("port")) run.port = json_value<std::string>(json, "port", "a text", path);
    if (json.contains("summary"))
        run.summary = read_summary(json_value<Json>(json, "summary", "an object", path), path);
    if (json.contains("replay")) run.replay = read_replay(json_value<Json>(json, "replay", "an object", path), path);
    return run;
}

} // namespace twiddle::record
