#include "claims/finger_use.hpp"
#include "claims/learning_course.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace twiddle::claims;
using Values = std::vector<double>;

// One row a control step of 10 ms, over 3 s, as trajectory.csv has them.
Values times_s()
{
    Values times;
    for (int step = 1; step <= 300; ++step) {
        times.push_back(step * 0.01);
    }
    return times;
}

Values swing(double mean, double amplitude, double frequency_hz, double lag_turns)
{
    Values values;
    for (const double t : times_s()) {
        values.push_back(mean + amplitude * std::cos(2 * std::acos(-1.0) * (frequency_hz * t - lag_turns)));
    }
    return values;
}

// A curve that rises by 1 rad a trial, 250 trials long, is averaged over 5: the mean of the last five is at least 100
// from trial 102 on.
TEST(LearningCourse, trials_to_reach_on_a_ramp)
{
    Values ramp;
    for (int trial = 1; trial <= 250; ++trial) {
        ramp.push_back(trial);
    }
    EXPECT_EQ(smoothing_trials(250), 5U);
    EXPECT_EQ(trials_to_reach(ramp, 100), 102U);
    EXPECT_EQ(trials_to_reach(ramp, 1), 5U);
    EXPECT_EQ(trials_to_reach(ramp, 1000), 250U);
    EXPECT_EQ(smoothing_trials(5000), 100U);
    EXPECT_EQ(smoothing_trials(10'000), 100U);
    EXPECT_EQ(smoothing_trials(3), 1U);
}

// One lucky trial is no learning: 9 rad among zeros, averaged over two trials, is 4.5.
TEST(LearningCourse, lucky_trial_is_averaged)
{
    Values rotation(100, 0.0);
    rotation[30] = 9;
    EXPECT_EQ(trials_to_reach(rotation, 5), 100U);
    EXPECT_EQ(trials_to_reach(rotation, 4.5), 31U);
}

// Distances by hand, and a course whose weights step at trials 500, 2,000 and 2,500.
TEST(LearningCourse, mixtures_by_hand)
{
    EXPECT_EQ(mixture_distance({1, 0, 0}, {0, 0, 1}), 1);
    EXPECT_NEAR(mixture_distance({0.5, 0.3, 0.2}, {0.4, 0.3, 0.3}), 0.1, 1e-15);
    Values s_c(5000, 0.25);
    Values s_m(5000, 0.25);
    Values s_s(5000, 0.5);
    std::fill(s_c.begin(), s_c.begin() + 500, 0.75);
    std::fill(s_s.begin(), s_s.begin() + 500, 0.0);
    std::fill(s_c.begin() + 2000, s_c.begin() + 2500, 0.5);
    std::fill(s_s.begin() + 2000, s_s.begin() + 2500, 0.25);
    const MixtureCourse course = mixture_course(s_c, s_m, s_s);
    EXPECT_EQ(*course.first, (Mixture{0.75, 0.25, 0}));
    EXPECT_EQ(*course.middle, (Mixture{0.5, 0.25, 0.25}));
    EXPECT_EQ(course.last, (Mixture{0.25, 0.25, 0.5}));
    const MixtureCourse of_short = mixture_course(Values(2999, 0.5), Values(2999, 0.25), Values(2999, 0.25));
    EXPECT_FALSE(of_short.first || of_short.middle);
    EXPECT_EQ(of_short.last, (Mixture{0.5, 0.25, 0.25}));
}

// By hand: the index alone turns 1 rad, both with 1 N and 3 N 2 rad, the thumb alone 0.5 rad; 0.4 rad backwards, 0.4
// rad without a finger and forces without turning count for none: 1.5 of 3.5 rad by the index.
TEST(FingerUse, lesser_share_by_hand)
{
    const Values object_rad = {1, 3, 3.5, 3.1, 3.5, 3.5};
    const Values index_n = {2, 1, 0, 5, 0, 7};
    const Values thumb_n = {0, 3, 4, 0, 0, 0};
    EXPECT_NEAR(lesser_finger_share(object_rad, index_n, thumb_n), 1.5 / 3.5, 1e-12);
    EXPECT_EQ(lesser_finger_share({1, 2}, {1, 1}, {0, 0}), 0);
    EXPECT_EQ(lesser_finger_share({1, 2}, {0, 0}, {0, 0}), 0);
}

// Synthetic joints with known lags; frequencies that do not fit the 2 s, other means, amplitudes and
// harmonics change nothing.
TEST(FingerUse, phase_distance_of_known_lags)
{
    for (const double frequency_hz : {0.3, 0.73, 1.0, 2.0}) {
        for (const double lag_turns : {0.0, 0.1, 0.25, 0.5, 0.7, -0.4, 1.2}) {
            const double expected = std::abs(lag_turns - std::round(lag_turns));
            EXPECT_NEAR(phase_distance_turns(times_s(), swing(0.3, 0.2, frequency_hz, 0.15),
                                             swing(-1, 0.7, frequency_hz, 0.15 + lag_turns), frequency_hz),
                        expected, 1e-6)
                << frequency_hz << " Hz, lag " << lag_turns;
        }
    }
    Values with_harmonic = swing(0, 1, 1, 0.5);
    const Values harmonic = swing(0, 0.5, 2, 0.3);
    for (std::size_t i = 0; i < with_harmonic.size(); ++i) {
        with_harmonic[i] += harmonic[i];
    }
    EXPECT_NEAR(phase_distance_turns(times_s(), swing(0, 1, 1, 0), with_harmonic, 1), 0.5, 1e-6);
}

// Only the last 2 s count: what happens before, while centres still move, changes nothing.
TEST(FingerUse, phase_is_that_of_the_last_two_seconds)
{
    Values late = swing(0, 1, 1, 0.3);
    std::fill(late.begin(), late.begin() + 100, 50.0);
    EXPECT_NEAR(phase_distance_turns(times_s(), swing(0, 1, 1, 0), late, 1), 0.3, 1e-6);
}

} // namespace
