// Whether the default substeps resolve the contacts: creep, convergence of rotations, penetration.
#include "random_trials.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace twiddle::experiment
{

namespace
{

constexpr unsigned seed = 60;
constexpr int sets = 60;

Outcome run_sets(const std::string &object, int substeps)
{
    TrialRunner runner = make_runner(sim::Stepper::reference, object, substeps);
    return run_sets(runner, sets, seed);
}

class ContactQuality : public testing::TestWithParam<const char *>
{
};

} // namespace

// Final rotations over 60 random parameter sets correlate at least 0.95 with a run of 50 substeps, and no finger
// reaches more than 1.5 mm into the object, at the default substeps. The curve against substeps is printed.
TEST_P(ContactQuality, default_substeps_agree_with_a_converged_run)
{
    const std::string object = GetParam();
    const int default_substeps = sim::default_setup().physics.substeps;
    const Outcome converged = run_sets(object, 50);
    std::printf("%s, %d parameter sets, seed %u; 50 substeps: mean %.3f rad\n", object.c_str(), sets, seed,
                mean(converged.rotation_rad));
    bool checked = false;
    for (const int substeps : {2, 3, 5, 10, 20}) {
        const Outcome outcome = run_sets(object, substeps);
        const double r = correlation(outcome.rotation_rad, converged.rotation_rad);
        std::printf("  %2d substeps: r = %.4f, mean %.3f rad, deepest %.2f mm\n", substeps, r,
                    mean(outcome.rotation_rad), 1e3 * outcome.deepest_m);
        if (substeps != default_substeps) continue;
        checked = true;
        EXPECT_GE(r, 0.95);
        EXPECT_LE(outcome.deepest_m, 1.5e-3);
    }
    EXPECT_TRUE(checked) << "the curve does not hold the default number of substeps";
}

// An object that both fingers press without moving stays.
TEST_P(ContactQuality, pressed_object_does_not_creep)
{
    TrialRunner runner = make_runner(sim::Stepper::reference, GetParam(), sim::default_setup().physics.substeps);
    expect_no_creep(runner, GetParam());
}

// With all 19 joints movable and the held ones on motors, the small sphere turns as with rigid ones. Expected: the
// welded hand's rotations.
TEST(HandHolds, full_hand_turns_the_object_as_the_welded_one_does)
{
    constexpr int full_sets = 20;
    const int substeps = sim::default_setup().physics.substeps;
    TrialRunner welded = make_runner(sim::Stepper::reference, "small-sphere", substeps);
    TrialRunner full = make_runner(sim::Stepper::reference, "small-sphere", substeps, sim::HandHold::full);
    std::mt19937_64 random(seed);
    std::vector<double> welded_rad, full_rad;
    for (int i = 0; i < full_sets; i++) {
        const engine::Parameters parameters = random_parameters(random);
        welded_rad.push_back(welded.run(parameters).rotation_rad);
        full_rad.push_back(full.run(parameters).rotation_rad);
    }
    const double r = correlation(welded_rad, full_rad);
    std::printf("%d parameter sets, seed %u: welded mean %.3f rad, full mean %.3f rad, r = %.4f\n", full_sets, seed,
                mean(welded_rad), mean(full_rad), r);
    EXPECT_GE(r, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Shapes, ContactQuality, testing::Values("small-sphere", "medium-cylinder", "large-cube"),
                         [](const auto &shape) {
                             std::string name = shape.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace twiddle::experiment
