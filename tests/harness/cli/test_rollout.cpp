#include "program.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace twiddle::test;

const std::string rollout = "rollout --object small-sphere --model cpg-s ";

// One rotation a line comes out, the same for the same line wherever it stands. Expected: equal texts for equal lines.
TEST(Rollout, same_line_gives_the_same_rotation)
{
    const Outcome outcome = run_twiddle(rollout, "0.5,0.5\n0.9,0.3\n 0.5 ,\t5e-1\r\n");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.error, "");
    std::vector<std::string> lines;
    std::istringstream text(outcome.output);
    for (std::string line; std::getline(text, line);) {
        lines.push_back(line);
    }
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0], lines[2]);
    EXPECT_NE(lines[0], lines[1]);
}

// A wrong line is named, with status 2, after the rotations of the lines before it. Expected: one rotation,
// from the first line.
TEST(Rollout, wrong_line_is_named)
{
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"0.5", "expected 2 values in (0,1), found 1"}, {"0.5,0.5,0.5", "expected 2 values in (0,1), found 3"},
        {"", "expected 2 values in (0,1), found 0"},    {"0.5,", "'' is no number in (0,1)"},
        {"0.5,1", "'1' is no number in (0,1)"},         {"0,0.5", "'0' is no number in (0,1)"},
        {"0.5,-0.5", "'-0.5' is no number in (0,1)"},   {"0.5,nan", "'nan' is no number in (0,1)"},
        {"0.5,half", "'half' is no number in (0,1)"},   {"0.5,0.5x", "'0.5x' is no number in (0,1)"}};
    const std::string first = run_twiddle(rollout, "0.5,0.5\n").output;
    for (const auto &[line, expected] : cases) {
        const Outcome outcome = run_twiddle(rollout, "0.5,0.5\n" + line + "\n0.5,0.5\n");
        EXPECT_EQ(outcome.status, 2) << line;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find("line 2 of standard input: " + expected), std::string::npos) << outcome.error;
        EXPECT_EQ(outcome.output, first) << line;
    }
}

// No input is no work.
TEST(Rollout, empty_input_is_no_work)
{
    const Outcome outcome = run_twiddle(rollout + "--no-centre");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.output, "");
}

} // namespace
