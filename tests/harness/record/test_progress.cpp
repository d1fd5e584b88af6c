#include "record/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace
{

using namespace twiddle::record;

// Durations read as on a clock. Expected: by hand.
TEST(Progress, durations_read_as_on_a_clock)
{
    EXPECT_EQ(duration_text(0), "0:00");
    EXPECT_EQ(duration_text(57.4), "0:57");
    EXPECT_EQ(duration_text(59.6), "1:00");
    EXPECT_EQ(duration_text(723), "12:03");
    EXPECT_EQ(duration_text(3723), "1:02:03");
    EXPECT_EQ(duration_text(-1), "?");
    EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "?");
}

// The mean covers the last 100 values, or all of fewer. Expected: the sums of arithmetic series.
TEST(Progress, mean_covers_the_last_hundred)
{
    MovingMean mean;
    EXPECT_EQ(mean.mean(), 0);
    for (int i = 1; i <= 250; ++i) {
        mean.add(i);
        if (i == 4) {
            EXPECT_EQ(mean.mean(), 2.5); // (1 + 2 + 3 + 4) / 4
        }
    }
    EXPECT_EQ(mean.mean(), 200.5); // 151 to 250
}

// Bar and line name trial, reward, speed and time left. Expected: by hand; 750 trials at 50 trials/s are 15 s.
TEST(Progress, bar_and_line_name_trial_reward_speed_and_time_left)
{
    const ProgressState state{250, 1000, 1.2345, 50};
    EXPECT_EQ(progress_bar(state), "trial 250/1000 [#####...............] reward 1.23  50.0 trials/s  0:15 left");
    EXPECT_EQ(progress_line(state),
              "trial 250 of 1000 (25 %): reward 1.234 (mean of the last 100), 50.0 trials/s, 0:15 left");
}

// Off a terminal there are ten lines for any number of trials from ten on, and no control characters. Expected:
// ten, by definition.
TEST(Progress, plain_lines_come_every_tenth)
{
    for (const std::uint32_t trials : {10U, 37U, 5000U}) {
        std::ostringstream out;
        Progress progress(out, false, trials, 0);
        for (std::uint32_t i = 0; i < trials; ++i) {
            progress.update(1, i + 1.0);
        }
        const std::string text = out.str();
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10) << trials;
        EXPECT_EQ(text.find_first_of("\r\033"), std::string::npos);
        EXPECT_NE(text.find("(100 %)"), std::string::npos);
    }
}

// On a terminal the bar is redrawn in place at most ten times a second and ends with a line end. Expected: 2 s of
// updates at 1 kHz, the first and every 0.1 s after: 20, and the last one.
TEST(Progress, bar_redraws_in_place)
{
    std::ostringstream out;
    Progress progress(out, true, 2000, 0);
    for (int i = 1; i <= 2000; ++i) {
        progress.update(1, i * 0.001);
    }
    const std::string text = out.str();
    const auto draws = std::count(text.begin(), text.end(), '\r');
    EXPECT_GE(draws, 20);
    EXPECT_LE(draws, 22);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
    EXPECT_EQ(text.back(), '\n');
}

// A run that goes on counts earlier trials as done, but not in its speed. Expected: 10 trials in 5 s are 2 a second.
TEST(Progress, resumed_run_counts_only_its_own_speed)
{
    std::ostringstream out;
    Progress progress(out, false, 100, 90);
    progress.recall(3);
    for (int i = 1; i <= 10; ++i) {
        progress.update(3, i * 0.5);
    }
    EXPECT_EQ(out.str(), "trial 100 of 100 (100 %): reward 3.000 (mean of the last 100), 2.0 trials/s, 0:00 left\n");
}

// A sweep's bar and line name runs, failures, speed and time left. Expected: by hand; 3000 trials at 1500
// trials/s are 2 s.
TEST(SweepProgress, bar_and_line_name_runs_failures_speed_and_time_left)
{
    SweepState state{1, 4, 0, 1000, 3000, 1500};
    EXPECT_EQ(sweep_bar(state), "1/4 runs [#####...............]  1500.0 trials/s  0:02 left");
    EXPECT_EQ(sweep_line(state), "1 of 4 runs (25 % of the trials): 1500.0 trials/s, 0:02 left");
    state.failed = 2;
    EXPECT_EQ(sweep_bar(state), "1/4 runs [#####...............]  2 failed  1500.0 trials/s  0:02 left");
    EXPECT_EQ(sweep_line(state), "1 of 4 runs, 2 failed (25 % of the trials): 1500.0 trials/s, 0:02 left");
}

// Off a terminal there is a plain line every ten seconds, on one a bar at most ten times a second, in place. Expected:
// of 60 s of updates at 16 Hz, every second one draws the bar, 480, and the end does.
TEST(SweepProgress, draws_at_its_intervals)
{
    for (const bool terminal : {false, true}) {
        std::ostringstream out;
        SweepProgress progress(out, terminal);
        for (int i = 1; i <= 960; ++i) {
            progress.update({1, 4, 0, 1000, 3000, 1500}, i / 16.0);
        }
        progress.update({4, 4, 0, 4000, 0, 1500}, 60.01);
        progress.end_line();
        const std::string text = out.str();
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), terminal ? 1 : 6);
        EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), terminal ? 481 : 0);
    }
}

} // namespace
