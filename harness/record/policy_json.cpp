#include "policy_json.hpp"

#include "json_file.hpp"

namespace twiddle::record
{

void write_policy(const std::filesystem::path &path, const Policy &policy)
{
    Json json;
    json["what"] = "a learned policy of twiddle: parameters in (0, 1) without noise, and the learner's state";
    json["model"] = policy.model;
    json["centre"] = policy.centre;
    json["trials"] = policy.trials;
    json["parameters"] = Json::object();
    for (const auto &[name, value] : policy.parameters) {
        json["parameters"][name] = value;
    }
    json["learner"]["critic_weights"] = policy.critic_weights;
    json["learner"]["actor_weights"] = policy.actor_weights;
    json["learner"]["random_state"] = policy.random_state;
    write_json(path, json);
}

Policy read_policy(const std::filesystem::path &path)
{
    const Json json = read_json(path);
    Policy policy;
    policy.model = json_value<std::string>(json, "model", "a text", path);
    policy.centre = json_value<bool>(json, "centre", "true or false", path);
    policy.trials = json_value<std::uint32_t>(json, "trials", "a whole number", path);

    const Json parameters = json_value<Json>(json, "parameters", "an object of named numbers", path);
    for (const auto &[name, value] : parameters.items()) {
        if (!value.is_number() || !(value > 0.0) || !(value < 1.0))
            throw std::runtime_error("'" + path.string() + "': parameter '" + name + "' must be a number in (0, 1)");
        policy.parameters.emplace_back(name, value.get<double>());
    }
    const Json learner = json_value<Json>(json, "learner", "an object", path);
    policy.critic_weights = json_value<std::vector<double>>(learner, "critic_weights", "a list of numbers", path);
    policy.actor_weights =
        json_value<std::vector<std::vector<double>>>(learner, "actor_weights", "a list of lists of numbers", path);
    policy.random_state =
        json_value<std::array<std::uint32_t, 4>>(learner, "random_state", "a list of four whole numbers", path);
    return policy;
}

} // namespace twiddle::record
