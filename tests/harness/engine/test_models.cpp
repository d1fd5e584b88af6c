#include "engine/models.hpp"

#include "engine/control_loop.hpp"
#include "engine/library_models.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

using namespace twiddle::engine;
using namespace twiddle::engine::TWD_BUILD_NAMESPACE;

// Every parameter has one name, and there are as many as Ciancio et al. 2011 count: 2, 5, 12, 22 with centre; 1,
// 3, 8, 15 without.
TEST(Models, parameters_are_as_many_as_the_paper_counts)
{
    const std::vector<std::string> names = model_names();
    ASSERT_EQ(names, (std::vector<std::string>{"cpg-s", "cpg-m", "cpg-c", "cpg-h"}));
    const std::vector<std::size_t> with = {2, 5, 12, 22};
    const std::vector<std::size_t> without = {1, 3, 8, 15};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const twd_model &model = find_model(names[i]);
        EXPECT_EQ(parameter_names(names[i], true).size(), with[i]);
        EXPECT_EQ(parameter_names(names[i], false).size(), without[i]);
        EXPECT_EQ(twd_model_parameters(&model, true), with[i]);
        EXPECT_EQ(twd_model_parameters(&model, false), without[i]);
    }
}

// The order is nu, R, C, phi for each CPG, C, M, S, then the selector. Expected: written out by hand for CPG-H.
TEST(Models, parameter_names_follow_the_stated_order)
{
    const std::vector<std::string> expected = {
        "cpg-c.frequency",     "cpg-c.amplitude-1",   "cpg-c.amplitude-2", "cpg-c.amplitude-3", "cpg-c.amplitude-4",
        "cpg-c.centre-1",      "cpg-c.centre-2",      "cpg-c.centre-3",    "cpg-c.centre-4",    "cpg-c.phase-lag-1-2",
        "cpg-c.phase-lag-1-3", "cpg-c.phase-lag-3-4", "cpg-m.amplitude-1", "cpg-m.amplitude-2", "cpg-m.centre-1",
        "cpg-m.centre-2",      "cpg-m.phase-lag-1-2", "cpg-s.amplitude-1", "cpg-s.centre-1",    "selector.cpg-c",
        "selector.cpg-m",      "selector.cpg-s"};
    EXPECT_EQ(parameter_names("cpg-h", true), expected);
    EXPECT_EQ(parameter_names("cpg-s", false), (std::vector<std::string>{"cpg-s.amplitude-1"}));
}

// An unknown model's error lists the known ones.
TEST(Models, unknown_model_lists_the_known_ones)
{
    try {
        find_model("cpg-x");
        FAIL() << "cpg-x was found";
    } catch (const std::invalid_argument &error) {
        EXPECT_STREQ(error.what(), "unknown model 'cpg-x'; the models are cpg-s, cpg-m, cpg-c, cpg-h");
    }
}

// A model's weights land in the column of their CPG, C, M, S; absent CPGs have none.
TEST(Models, weights_land_in_their_experts_column)
{
    const twd_num one = TWD_NUM(1);
    EXPECT_EQ(expert_weights(find_model("cpg-c"), &one), (ExpertWeights{1, 0, 0}));
    EXPECT_EQ(expert_weights(find_model("cpg-m"), &one), (ExpertWeights{0, 1, 0}));
    EXPECT_EQ(expert_weights(find_model("cpg-s"), &one), (ExpertWeights{0, 0, 1}));
    const std::array<twd_num, 3> mixture = {TWD_NUM(0.5), TWD_NUM(0.25), TWD_NUM(0.25)};
    EXPECT_EQ(expert_weights(find_model("cpg-h"), mixture.data()), (ExpertWeights{0.5, 0.25, 0.25}));
}

} // namespace
