#include "calibration/plan.hpp"

#include "scratch_folder.hpp"

#include <gtest/gtest.h>

namespace
{

using namespace twiddle::calibration;
using namespace twiddle::test;

const std::filesystem::path setups = TWIDDLE_SETUPS;

const std::string head = "setup = \"near\"\nseed = 1\nobjects = [\"small-sphere\"]\n"
                         "[screening]\ntrials = 10\nseeds = 1\nrandom = 3\nrefined = 2\nparents = 2\n"
                         "[finalists]\ncount = 1\ntrials = 20\nseeds = 2\n"
                         "[reach]\nindex_fei_deg = [25, 60]\nindex_aai_deg = [-15, 15]\nthumb_fet_deg = [25, "
                         "60]\nthumb_ot_deg = [40, 110]\n";
const std::string variable = "[[variables]]\nsetting = \"object.mass_kg\"\nrange = [0.1, 0.2]\n";

CalibrationPlan plan_of_text(const std::string &text)
{
    const ScratchFolder folder;
    return read_calibration_plan(folder.write("mine.toml", text), TWIDDLE_MODELS, setups);
}

std::string complaint(const std::string &text)
{
    return error_of([&] { plan_of_text(text); });
}

// The three objects are one a size and one a shape, so that six are held out.
TEST(CalibrationPlan, the_repository_compares_three_objects_and_trains_twelve_finalists_in_full)
{
    const CalibrationPlan plan =
        read_calibration_plan(setups.parent_path() / "calibrations" / "paper.toml", TWIDDLE_MODELS, setups);
    EXPECT_EQ(plan.objects, (std::vector<std::string>{"small-sphere", "medium-cylinder", "large-cube"}));
    EXPECT_EQ(plan.finalists, 12U);
    EXPECT_EQ(plan.finals.trials, 5000U);
    EXPECT_EQ(plan.finals.seeds, 4U);
    EXPECT_EQ(plan.reach.index_fei_deg, (std::pair<double, double>(25, 60)));
}

TEST(CalibrationPlan, says_line_and_key_of_what_is_wrong)
{
    EXPECT_EQ(plan_of_text(head + variable).variables.size(), 1U);
    const std::string scaled =
        "[[variables]]\nsetting = \"object.mass_kg\"\nrange = [0, 0.2]\nscale = \"logarithmic\"\n";
    const std::string unknown = "[[variables]]\nsetting = \"object.colour\"\nrange = [0, 1]\n";
    const std::string too_wide = "[[variables]]\nsetting = \"contact.friction\"\nrange = [0, 9]\n";
    const std::string reversed = "[[variables]]\nsetting = \"object.mass_kg\"\nrange = [0.2, 0.1]\n";
    const std::string both = variable + "values = [0.1]\n";
    EXPECT_TRUE(is_one_sentence_with(complaint(head), {"mine.toml", "[[variables]]"}));
    EXPECT_TRUE(is_one_sentence_with(complaint(head + scaled), {"mine.toml:21", "range", "above 0"}));
    EXPECT_TRUE(is_one_sentence_with(complaint(head + unknown), {"mine.toml:19", "colour"}));
    EXPECT_TRUE(is_one_sentence_with(complaint(head + too_wide), {"mine.toml:19", "friction", "from 0 to 5"}));
    EXPECT_TRUE(is_one_sentence_with(complaint(head + reversed), {"mine.toml:21", "in order"}));
    EXPECT_TRUE(is_one_sentence_with(complaint(head + both), {"mine.toml:22", "values"}));
    EXPECT_TRUE(is_one_sentence_with(complaint("colour = 1\n" + head + variable), {"mine.toml:1", "colour"}));
}

} // namespace
