#include "calibration/search_space.hpp"

#include "scratch_folder.hpp"
#include "setups.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace
{

using namespace twiddle;
using namespace twiddle::calibration;
using nlohmann::json;

const std::vector<Variable> variables = {
    {"object.hinge_x_m", 0.02, 0.07, false, {}},
    {"object.coulomb_nm", 0.001, 0.1, true, {}},
    {"object.cube_size", 0, 0, false, {"whole-diagonal", "half-diagonal"}},
    {gains_variable, 30, 80, false, {}},
};

std::string settings()
{
    return test::load_setup("mid-a").settings;
}

// Half way between 0.001 and 0.1 by factors is their geometric mean, 0.01.
TEST(SearchSpace, ends_and_middles_of_ranges_are_where_their_scales_put_them)
{
    EXPECT_EQ(values_at(variables, {0, 0, 0, 0}), (std::vector<json>{0.02, 0.001, "whole-diagonal", 30.0}));
    EXPECT_EQ(values_at(variables, {1, 1, 1, 1}), (std::vector<json>{0.07, 0.1, "half-diagonal", 80.0}));
    EXPECT_EQ(values_at(variables, {0.5, 0.5, 0.49, 0.5}), (std::vector<json>{0.045, 0.01, "whole-diagonal", 55.0}));
}

TEST(SearchSpace, numbers_have_three_significant_digits)
{
    const Variable wide{"object.mass_kg", 0, 1, false, {}};
    EXPECT_EQ(values_at({wide}, {0.123456})[0], json(0.123));
    EXPECT_EQ(values_at({wide}, {0.000987654})[0], json(0.000988));
    EXPECT_EQ(values_at({wide}, {0.99996})[0], json(1.0));
}

// At half the natural frequency a critically damped joint has a quarter of the stiffness and half of the damping.
// mid-a's FEI has 0.21 N m/rad and 0.0069 N m s/rad at 60 rad/s.
TEST(SearchSpace, the_natural_frequency_moves_all_gains_and_keeps_the_damping_ratio)
{
    const json base = json::parse(settings());
    const json half = json::parse(with_values(settings(), {variables[3]}, {30.0}));
    EXPECT_NEAR(half["hand"]["stiffness_nm_per_rad"]["fei"].get<double>(), 0.0525, 1e-12);
    EXPECT_NEAR(half["hand"]["damping_nms_per_rad"]["fei"].get<double>(), 0.00345, 1e-12);
    for (const char *joint : {"aai", "fet", "ot"}) {
        const double stiffness = base["hand"]["stiffness_nm_per_rad"][joint];
        EXPECT_NEAR(half["hand"]["stiffness_nm_per_rad"][joint].get<double>(), stiffness / 4, 5e-4 * stiffness);
    }
    EXPECT_EQ(json::parse(with_values(settings(), {variables[3]}, {60.0})), base);
}

TEST(SearchSpace, a_written_set_up_reads_back_as_the_settings_that_were_tried)
{
    const test::ScratchFolder folder;
    const auto values = values_at(variables, {0.3, 0.7, 0.9, 0.1});
    const auto path = folder.write("found.toml", setup_text(settings(), variables, values, {"found by a test"}));
    EXPECT_EQ(json::parse(test::load_setup(path.string()).settings),
              json::parse(with_values(settings(), variables, values)));
}

} // namespace
