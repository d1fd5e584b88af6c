// Whether the default substeps resolve the contacts: creep, convergence of rotations, penetration.
#include "fixtures.hpp"

#include "experiment/models.hpp"
#include "experiment/trial.hpp"
#include "sim/object.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace twiddle::experiment
{

namespace
{

constexpr unsigned seed = 60;
constexpr int sets = 60;

TrialRunner make_runner(const std::string &object, int substeps, sim::HandHold hold = sim::HandHold::welded)
{
    const sim::Setup setup = sim::default_setup({{"physics.substeps", std::to_string(substeps)}});
    return {sim::Stepper::reference,
            sim::icub_hand(),
            sim::read_object(TWIDDLE_MODELS, object),
            setup,
            hold,
            find_model("cpg-c"),
            true};
}

struct Outcome {
    std::vector<double> rotation_rad; // [sets]
    double deepest_m = 0;             // over all control steps of all sets
};

// The same 60 random parameter sets of CPG-C for every number of substeps.
Outcome run_sets(const std::string &object, int substeps)
{
    TrialRunner runner = make_runner(object, substeps);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0.001, 0.999);
    Outcome outcome;
    for (int i = 0; i < sets; i++) {
        Parameters parameters(12);
        for (twd_num &p : parameters)
            p = static_cast<twd_num>(uniform(random));
        const auto result = runner.run_observed(parameters, [&](const StepSample &, const sim::World &world) {
            outcome.deepest_m = std::max(outcome.deepest_m, world.observe().deepest_m);
        });
        EXPECT_EQ(result.fault, "");
        outcome.rotation_rad.push_back(result.rotation_rad);
    }
    return outcome;
}

double mean(const std::vector<double> &values)
{
    double sum = 0;
    for (const double v : values)
        sum += v;
    return sum / static_cast<double>(values.size());
}

// Pearson's r.
double correlation(const std::vector<double> &a, const std::vector<double> &b)
{
    const double mean_a = mean(a), mean_b = mean(b);
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); i++) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return ab / std::sqrt(aa * bb);
}

class ContactQuality : public testing::TestWithParam<const char *>
{
};

} // namespace

// Final rotations over 60 random parameter sets correlate at least 0.95 with a run of 50 substeps, and no finger reaches
// more than 1.5 mm into the object, at the default substeps. The curve against substeps is printed.
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

// An object that both fingers press without moving stays: it creeps less than 0.005 rad in 1.5 s after the first 1.5 s.
// Amplitudes are 0 and the centres press the index (and, by case, the thumb) on the object.
TEST_P(ContactQuality, pressed_object_does_not_creep)
{
    struct Press {
        double index, abduction, thumb, opposition; // centres of FEI, AAI, FET, OT
    };
    TrialRunner runner = make_runner(GetParam(), sim::default_setup().physics.substeps);
    int pressing = 0;
    for (const Press press : {Press{0.75, 0.5, 0, 0.3}, Press{0.9, 0.1, 0, 0.3}, Press{0.75, 0.9, 0, 0.3},
                              Press{0, 0.5, 0.7, 0.5}, Press{0, 0.5, 0.7, 0.8}, Press{0.75, 0.5, 0.7, 0.5}}) {
        // Order: nu, R1..4, C1..4 (FEI, AAI, FET, OT), three lags.
        Parameters parameters(12, 0);
        parameters[5] = static_cast<twd_num>(press.index);
        parameters[6] = static_cast<twd_num>(press.abduction);
        parameters[7] = static_cast<twd_num>(press.thumb);
        parameters[8] = static_cast<twd_num>(press.opposition);
        double settled_rad = 0, force_n = 0, creep_rad = 0;
        runner.run_observed(parameters, [&](const StepSample &sample, const sim::World &world) {
            const sim::Observation seen = world.observe();
            if (sample.step == 150) settled_rad = seen.object_rad;
            if (sample.step <= 150) return;
            creep_rad = std::max(creep_rad, std::abs(seen.object_rad - settled_rad));
            force_n = seen.index_contact_n + seen.thumb_contact_n;
        });
        std::printf("%s, centres %.2f %.2f %.2f %.2f: %.2f N, creep %.1e rad\n", GetParam(), press.index,
                    press.abduction, press.thumb, press.opposition, force_n, creep_rad);
        if (force_n > 0.1) pressing++;
        EXPECT_LT(creep_rad, 0.005);
    }
    EXPECT_GE(pressing, 3) << "too few of the cases press the object";
}

// With all 19 joints movable and the held ones on motors, the small sphere turns as with rigid ones. Expected: the welded hand's
// rotations.
TEST(HandHolds, full_hand_turns_the_object_as_the_welded_one_does)
{
    constexpr int full_sets = 20;
    const int substeps = sim::default_setup().physics.substeps;
    TrialRunner welded = make_runner("small-sphere", substeps);
    TrialRunner full = make_runner("small-sphere", substeps, sim::HandHold::full);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0.001, 0.999);
    std::vector<double> welded_rad, full_rad;
    for (int i = 0; i < full_sets; i++) {
        Parameters parameters(12);
        for (twd_num &p : parameters)
            p = static_cast<twd_num>(uniform(random));
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
