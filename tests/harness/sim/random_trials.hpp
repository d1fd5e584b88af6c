// random_trials.hpp: the same random trials for several worlds, and how far their outcomes agree.
#pragma once

#include "fixtures.hpp"

#include "experiment/trial.hpp"
#include "sim/object.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace twiddle::experiment
{

inline TrialRunner make_runner(sim::Stepper stepper, const std::string &object, int substeps,
                               sim::HandHold hold = sim::HandHold::welded)
{
    const settings::Setup setup = sim::default_setup({{"physics.substeps", std::to_string(substeps)}});
    return {TrialWorld(stepper, sim::icub_hand(), sim::read_object(TWIDDLE_MODELS, object), setup, hold),
            engine::engine_of_number("float"), "cpg-c", true};
}

inline engine::Parameters random_parameters(std::mt19937_64 &random, std::size_t count = 12)
{
    std::uniform_real_distribution<double> uniform(0.001, 0.999);
    engine::Parameters parameters(count);
    for (double &p : parameters)
        p = uniform(random);
    return parameters;
}

struct Outcome {
    std::vector<double> rotation_rad; // of each trial
    double deepest_m = 0;             // over all control steps of all trials
};

// `sets` random parameter sets of CPG-C; the seed alone decides which.
inline Outcome run_sets(TrialRunner &runner, int sets, unsigned seed)
{
    std::mt19937_64 random(seed);
    Outcome outcome;
    for (int i = 0; i < sets; i++) {
        const auto result =
            runner.run_observed(random_parameters(random), [&](const StepSample &, const sim::World &world) {
                outcome.deepest_m = std::max(outcome.deepest_m, world.observe().deepest_m);
            });
        EXPECT_EQ(result.fault, "");
        outcome.rotation_rad.push_back(result.rotation_rad);
    }
    return outcome;
}

inline double mean(const std::vector<double> &values)
{
    double sum = 0;
    for (const double v : values)
        sum += v;
    return sum / static_cast<double>(values.size());
}

// Pearson's r.
inline double correlation(const std::vector<double> &a, const std::vector<double> &b)
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

// An object that is pressed by fingers that stand still creeps less than 0.005 rad in 1.5 s after the first 1.5 s.
// Amplitudes are 0 and the centres press the index (and, by case, the thumb) on the object.
inline void expect_no_creep(TrialRunner &runner, const std::string &object)
{
    struct Press {
        double index, abduction, thumb, opposition; // centres of FEI, AAI, FET, OT
    };
    int pressing = 0;
    for (const Press press : {Press{0.75, 0.5, 0, 0.3}, Press{0.9, 0.1, 0, 0.3}, Press{0.75, 0.9, 0, 0.3},
                              Press{0, 0.5, 0.7, 0.5}, Press{0, 0.5, 0.7, 0.8}, Press{0.75, 0.5, 0.7, 0.5}}) {
        // Order: nu, R1..4, C1..4 (FEI, AAI, FET, OT), three lags.
        engine::Parameters parameters(12, 0.0);
        parameters[5] = press.index;
        parameters[6] = press.abduction;
        parameters[7] = press.thumb;
        parameters[8] = press.opposition;
        double settled_rad = 0, force_n = 0, creep_rad = 0;
        runner.run_observed(parameters, [&](const StepSample &sample, const sim::World &world) {
            const sim::Observation seen = world.observe();
            if (sample.step == 150) settled_rad = seen.object_rad;
            if (sample.step <= 150) return;
            creep_rad = std::max(creep_rad, std::abs(seen.object_rad - settled_rad));
            force_n = seen.index_contact_n + seen.thumb_contact_n;
        });
        std::printf("%s, centres %.2f %.2f %.2f %.2f: %.2f N, creep %.1e rad\n", object.c_str(), press.index,
                    press.abduction, press.thumb, press.opposition, force_n, creep_rad);
        if (force_n > 0.1) pressing++;
        EXPECT_LT(creep_rad, 0.005);
    }
    EXPECT_GE(pressing, 3) << "too few of the cases press the object";
}

} // namespace twiddle::experiment
