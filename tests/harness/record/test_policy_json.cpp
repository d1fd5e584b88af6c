#include "../scratch_folder.hpp"
#include "record/json_file.hpp"
#include "record/policy_json.hpp"

#include <gtest/gtest.h>

namespace
{

using namespace twiddle::record;
using twiddle::test::error_of;
using twiddle::test::is_one_sentence_with;
using twiddle::test::ScratchFolder;

Policy some_policy()
{
    Policy policy;
    policy.model = "cpg-s";
    policy.trials = 7;
    policy.parameters = {{"cpg-s.centre-1", 0.1}, {"cpg-s.amplitude-1", 1.0 / 3.0}}; // not the alphabet's order
    policy.actor_weights = {{0.1, -0.2}, {1e-300, 4.0}};
    policy.critic_weights = {5.0, 1.0 / 7.0};
    policy.random_state = {1, 2, 3, 4294967295U};
    return policy;
}

// A policy that was written and read is the same, in the same order. Expected: the policy itself, to the last bit.
TEST(PolicyJson, policy_reads_back_as_it_was)
{
    const ScratchFolder folder;
    const auto path = folder.path() / "policy.json";
    const Policy policy = some_policy();
    write_policy(path, policy);
    const Policy back = read_policy(path);
    EXPECT_EQ(back.model, policy.model);
    EXPECT_EQ(back.centre, policy.centre);
    EXPECT_EQ(back.trials, policy.trials);
    EXPECT_EQ(back.parameters, policy.parameters);
    EXPECT_EQ(back.actor_weights, policy.actor_weights);
    EXPECT_EQ(back.critic_weights, policy.critic_weights);
    EXPECT_EQ(back.random_state, policy.random_state);
}

// A parameter outside (0, 1), or none at all, is named.
TEST(PolicyJson, parameter_outside_its_range_is_named)
{
    const ScratchFolder folder;
    const auto path = folder.path() / "policy.json";
    write_policy(path, some_policy());
    const Json good = read_json(path);
    for (const Json &value : {Json(0.0), Json(1.0), Json(-3), Json("0.5"), Json(nullptr), Json(true)}) {
        Json wrong = good;
        wrong["parameters"]["cpg-s.centre-1"] = value;
        write_json(path, wrong);
        EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_policy(path); }), {path.string(), "'cpg-s.centre-1'"}));
    }
    Json wrong = good;
    wrong["learner"]["random_state"] = {1, 2, 3};
    write_json(path, wrong);
    EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_policy(path); }), {"'random_state'", "four whole numbers"}));
}

} // namespace
