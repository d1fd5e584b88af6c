#include "run_json.hpp"

#include "versions.hpp"

#include <tuple>

namespace twiddle::record
{

namespace
{

auto fields(const RunSpecification &s)
{
    return std::tie(s.object, s.model, s.centre, s.seed, s.trials, s.hand, s.stepper, s.number, s.setup, s.settings);
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
    specification.settings = json_value<nlohmann::json>(json, "settings", "an object of settings", path);
    return specification;
}

} // namespace

bool operator==(const RunSpecification &a, const RunSpecification &b)
{
    return fields(a) == fields(b);
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
    if (!run.summary.is_null()) json["summary"] = run.summary;
    if (!run.replay.is_null()) json["replay"] = run.replay;
    json["setup"] = specification.setup;
    json["settings"] = specification.settings;
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
    run.summary = json.value("summary", Json());
    run.replay = json.value("replay", Json());
    return run;
}

} // namespace twiddle::record
