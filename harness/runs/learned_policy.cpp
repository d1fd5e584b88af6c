#include "learned_policy.hpp"

#include "engine/models.hpp"
#include "usage_error.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace twiddle::runs
{

record::Run run_in(const RunFolder &folder)
{
    if (!std::filesystem::exists(folder.run_json()))
        throw UsageError("'" + folder.path.string() + "' is no folder of a run: it holds no run.json");
    return record::read_run(folder.run_json());
}

record::Policy learned_policy(const RunFolder &folder, const record::RunSpecification &specification)
{
    if (!std::filesystem::exists(folder.policy_json()))
        throw UsageError("'" + folder.path.string() +
                         "' holds no policy.json: its training is not complete; finish it by train --resume");
    record::Policy policy = record::read_policy(folder.policy_json());
    const std::vector<std::string> names = engine::parameter_names(specification.model, specification.centre);
    const bool same =
        std::equal(policy.parameters.begin(), policy.parameters.end(), names.begin(), names.end(),
                   [](const auto &parameter, const std::string &name) { return parameter.first == name; });
    if (!same)
        throw std::runtime_error("'" + folder.policy_json().string() + "': 'parameters' must be those of " +
                                 specification.model + (specification.centre ? "" : " without centre") + ", in order");
    return policy;
}

void require_learner(const RunFolder &folder, const record::RunSpecification &specification,
                     const record::Policy &policy)
{
    const auto require = [&](bool holds, const std::string &sentence) {
        if (!holds) throw std::runtime_error("'" + folder.policy_json().string() + "': " + sentence);
    };
    const std::size_t units = engine::parameter_count(specification.model, specification.centre);
    const std::size_t inputs = engine::input_count();
    require(policy.trials == specification.trials,
            "'trials' must be the run's " + std::to_string(specification.trials));
    require(policy.actor_weights.size() == units,
            "'actor_weights' must be " + std::to_string(units) + " lists, one a parameter");
    const bool rows_fit = std::all_of(policy.actor_weights.begin(), policy.actor_weights.end(),
                                      [&](const std::vector<double> &row) { return row.size() == inputs; });
    require(rows_fit && policy.critic_weights.size() == inputs,
            "'critic_weights' and each list of 'actor_weights' must be " + std::to_string(inputs) + " numbers");
    const auto &state = policy.random_state;
    require(std::any_of(state.begin(), state.end(), [](std::uint32_t word) { return word != 0; }),
            "'random_state' must not be all 0");
}

} // namespace twiddle::runs
