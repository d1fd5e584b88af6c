#include "../scratch_folder.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <string>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;

// Three points of one variable on one object, one finalist; the hand meets the object as in set-up mid-a.
std::string plan_text(const std::string &range = "[0.1, 0.2]")
{
    return "seed = 3\nobjects = [\"small-sphere\"]\n"
           "[screening]\ntrials = 20\nseeds = 1\nrandom = 2\nrefined = 1\nparents = 1\n"
           "[finalists]\ncount = 1\ntrials = 30\nseeds = 2\n"
           "[reach]\nindex_fei_deg = [0, 90]\nindex_aai_deg = [-15, 15]\nthumb_fet_deg = [0, 90]\nthumb_ot_deg = [0, "
           "130]\n"
           "[[variables]]\nsetting = \"object.mass_kg\"\nrange = " +
           range + "\n";
}

Outcome calibrate(const fs::path &plan, const fs::path &out, const std::string &jobs)
{
    return run_twiddle("calibrate " + plan.string() + " --out " + out.string() + " --jobs " + jobs);
}

// The first `lines` lines of a text.
std::string head_of(const std::string &text, int lines)
{
    std::size_t end = 0;
    for (int i = 0; i < lines; ++i) {
        end = text.find('\n', end) + 1;
    }
    return text.substr(0, end);
}

TEST(Calibrate, writes_all_candidates_and_a_set_up_that_trains)
{
    const ScratchFolder folder;
    const fs::path out = folder.path() / "out";
    const Outcome outcome = calibrate(folder.write("mine.toml", plan_text()), out, "2");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const std::string candidates = text_of(out / "candidates.csv");
    for (const char *row : {"\nscreening,0,", "\nscreening,1,", "\nscreening,2,", "\nfinals,"}) {
        EXPECT_NE(candidates.find(row), std::string::npos) << row;
    }
    const Outcome training =
        run_twiddle("train --object small-sphere --model cpg-s --trials 2 --setup " + (out / "setup-1.toml").string() +
                    " --out " + (folder.path() / "run").string());
    EXPECT_EQ(training.status, 0) << training.error;
}

TEST(Calibrate, an_interrupted_one_goes_on_and_gives_the_same_bytes)
{
    const ScratchFolder folder;
    const fs::path plan = folder.write("mine.toml", plan_text());
    ASSERT_EQ(calibrate(plan, folder.path() / "whole", "1").status, 0);
    const std::string whole = text_of(folder.path() / "whole" / "candidates.csv");
    folder.write("half/candidates.csv", head_of(whole, 7)); // four remarks, the columns, two points
    ASSERT_EQ(calibrate(plan, folder.path() / "half", "2").status, 0);
    EXPECT_EQ(text_of(folder.path() / "half" / "candidates.csv"), whole);
    EXPECT_EQ(text_of(folder.path() / "half" / "setup-1.toml"), text_of(folder.path() / "whole" / "setup-1.toml"));
}

TEST(Calibrate, leaves_the_folder_of_another_calibration_as_it_is)
{
    const ScratchFolder folder;
    const fs::path out = folder.path() / "out";
    ASSERT_EQ(calibrate(folder.write("mine.toml", plan_text()), out, "2").status, 0);
    const std::string before = text_of(out / "candidates.csv");
    const Outcome outcome = calibrate(folder.write("mine.toml", plan_text("[0.1, 0.3]")), out, "2");
    EXPECT_NE(outcome.status, 0);
    EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
    EXPECT_NE(outcome.error.find("another calibration"), std::string::npos) << outcome.error;
    EXPECT_EQ(text_of(out / "candidates.csv"), before);
}

TEST(Calibrate, refuses_a_broken_plan_with_one_sentence)
{
    const ScratchFolder folder;
    const Outcome outcome = calibrate(folder.write("mine.toml", plan_text("[2, 1]")), folder.path() / "out", "2");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
    EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

} // namespace
