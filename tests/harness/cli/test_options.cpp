#include "../scratch_folder.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace
{

using namespace twiddle::test;

// Wrong use, each in one sentence on standard error with exit status 2, naming what was wrong and what would be right.
TEST(Options, wrong_use_is_one_sentence_and_status_2)
{
    const std::string train = "train --object small-sphere --model cpg-h --out /nonexistent/out ";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "train, sweep, calibrate, replay, rollout, export, summarize, compare-claims, view or info"},
        {"juggle", "juggle"},
        {"train --model cpg-h", "--object is required"},
        {"train --object small-sphere", "--model is required"},
        {"train --object small-ball --model cpg-h", "small-ball'; the objects are small-sphere, small-cylinder"},
        {"train --object small-sphere --model cpg-x", "cpg-x'; the models are cpg-s, cpg-m, cpg-c, cpg-h"},
        {train + "--setup here", "here'; the set-ups are mid-b"},
        {train + "--setup /nowhere/here.toml", "/nowhere/here.toml"},
        {train + "--seed -1", "--seed -1: expected a whole number from 0"},
        {train + "--seed 18446744073709551616", "--seed"},
        {train + "--trials 0", "--trials 0: expected a whole number from 1"},
        {train + "--trials 1e3", "--trials 1e3"},
        {train + "--set contact.friction", "expected section.key=value"},
        {train + "--set friction=1", "expected section.key=value"},
        {train + "--set contact.friction=slippery", "slippery"},
        {train + "--set contact.grip=1", "grip"},
        {train + "--number half", "half' for --number; expected one of float, double, fixed"},
        {train + "--hand robot", "robot' for --hand; expected one of welded, full"},
        {train + "--faster", "--faster"},
        {train + "--models /nonexistent", "'/nonexistent' is no models folder"},
        {"replay", "RUN_DIR is required"},
        {"replay /nonexistent", "'/nonexistent' is no folder of a run"},
        {"info --models /nonexistent", "'/nonexistent' is no models folder"}};
    for (const auto &[arguments, expected] : cases) {
        const Outcome outcome = run_twiddle(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << arguments << ": " << outcome.error;
        EXPECT_NE(outcome.error.find(expected), std::string::npos) << arguments << ": " << outcome.error;
        EXPECT_EQ(outcome.output, "") << arguments;
    }
}

// A malformed set-up file is named with its line, and nothing is written.
TEST(Options, malformed_set_up_file_is_named)
{
    const ScratchFolder folder;
    const std::string setup = folder.write("mine.toml", "[contact]\nfriction = = 1\n").string();
    const std::string out = (folder.path() / "out").string();
    const Outcome outcome = run_twiddle("train --object small-sphere --model cpg-h --setup " + setup + " --out " + out);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
    EXPECT_NE(outcome.error.find(setup), std::string::npos) << outcome.error;
    EXPECT_FALSE(std::filesystem::exists(out));
}

// What the fast stepper does not cover is refused before anything is written; the stepper that the
// sentence names does it.
TEST(Options, what_the_fast_stepper_does_not_cover_is_left_to_the_reference)
{
    const ScratchFolder folder;
    const std::string out = (folder.path() / "out").string();
    const std::string train = "train --object small-sphere --model cpg-h --trials 1 --hand full --out " + out;
    const Outcome refused = run_twiddle(train);
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(is_one_complaint(refused.error)) << refused.error;
    EXPECT_NE(refused.error.find("--stepper reference"), std::string::npos) << refused.error;
    EXPECT_EQ(refused.output, "");
    EXPECT_FALSE(std::filesystem::exists(out));

    const Outcome taken = run_twiddle(train + " --stepper reference");
    EXPECT_EQ(taken.status, 0) << taken.error;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "trials.csv"));
}

// info lists the models with the paper's parameter counts and the nine objects; --help and --version succeed.
TEST(Options, info_and_help_succeed)
{
    const Outcome info = run_twiddle("info");
    EXPECT_EQ(info.status, 0);
    EXPECT_EQ(info.error, "");
    for (const char *expected : {"number type: float", "Bullet: ", "large-cube", "mid-b", "cpg-s: 2, 1", "cpg-m: 5, 3",
                                 "cpg-c: 12, 8", "cpg-h: 22, 15", TWIDDLE_MODELS}) {
        EXPECT_NE(info.output.find(expected), std::string::npos) << expected;
    }
    for (const char *arguments : {"--help", "--version", "train --help", "rollout --help"}) {
        EXPECT_EQ(run_twiddle(arguments).status, 0) << arguments;
    }
}

} // namespace
