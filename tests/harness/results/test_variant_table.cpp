#include "results/variant_table.hpp"

#include "results/variant_table_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

using namespace twiddle::results;

// Two objects, two models; "soft" changes CPG-H alone, "odd" has one object and a model that the base has not.
const std::vector<Cell> cells = {
    {"", "sphere", "cpg-c", true, {1, 3}, {}},     {"", "sphere", "cpg-h", true, {2, 2}, {}},
    {"", "cube", "cpg-c", true, {5, 7}, {}},       {"", "cube", "cpg-h", true, {4, 6}, {}},
    {"soft", "sphere", "cpg-c", true, {1, 3}, {}}, {"soft", "sphere", "cpg-h", true, {2, 4}, {}},
    {"soft", "cube", "cpg-c", true, {5, 7}, {}},   {"soft", "cube", "cpg-h", true, {10, 12}, {}},
    {"odd", "cube", "cpg-c", true, {0, 0}, {}},    {"odd", "cube", "cpg-m", true, {8, 8}, {}},
    {"single", "sphere", "cpg-c", true, {2.5}, {}}};

Sweep made_up_sweep()
{
    Sweep sweep;
    sweep.name = "tiny";
    sweep.version = "made-up 0.0";
    sweep.trials = 5000;
    sweep.changes = {{"soft", "contact.friction = 0.25"}, {"odd", "hand.pd_law = \"stable\""}};
    return sweep;
}

// Expected, by hand. "soft", CPG-H: means (3 + 11) / 2 and (2 + 5) / 2; the objects' resampled differences sum to 4
// with 1/64, to 4 or 5 with 7/64, so the interval begins at 5/2, and by symmetry ends at 9/2. "odd", CPG-C: 0 less 5, 6
// or 7 with 1/4, 1/2, 1/4.
TEST(VariantTable, variants_stand_beside_the_base)
{
    const VariantTable table = variant_table(made_up_sweep(), cells);
    ASSERT_EQ(table.conditions.size(), 2U);
    EXPECT_EQ(table.conditions[0].model, "cpg-h");
    EXPECT_EQ(table.conditions[1].model, "cpg-c");
    ASSERT_EQ(table.rows.size(), 3U);
    EXPECT_EQ(table.rows[0].variant, "odd"); // 6 rad are more than 3.5
    EXPECT_EQ(table.rows[1].variant, "soft");
    EXPECT_EQ(table.rows[2].variant, "single");

    ASSERT_EQ(table.rows[0].effects.size(), 1U);
    const VariantEffect &odd = table.rows[0].effects[0];
    EXPECT_EQ(odd.condition.model, "cpg-c");
    EXPECT_EQ(odd.objects, 1U);
    EXPECT_EQ(odd.mean_rad, 0);
    EXPECT_EQ(odd.base_mean_rad, 6);
    EXPECT_EQ(odd.difference_rad, -6);
    ASSERT_TRUE(odd.interval_rad.has_value());
    EXPECT_EQ(odd.interval_rad->lower, -7);
    EXPECT_EQ(odd.interval_rad->upper, -5);

    ASSERT_EQ(table.rows[1].effects.size(), 2U);
    const VariantEffect &soft = table.rows[1].effects[0];
    EXPECT_EQ(soft.objects, 2U);
    EXPECT_EQ(soft.runs, 4U);
    EXPECT_EQ(soft.base_runs, 4U);
    EXPECT_EQ(soft.mean_rad, 7);
    EXPECT_EQ(soft.base_mean_rad, 3.5);
    EXPECT_EQ(soft.difference_rad, 3.5);
    ASSERT_TRUE(soft.interval_rad.has_value());
    EXPECT_EQ(soft.interval_rad->lower, 2.5);
    EXPECT_EQ(soft.interval_rad->upper, 4.5);
    EXPECT_FALSE(soft.same_runs);
    EXPECT_TRUE(table.rows[1].effects[1].same_runs); // CPG-C

    EXPECT_EQ(table.rows[2].effects[0].difference_rad, 0.5);
    EXPECT_FALSE(table.rows[2].effects[0].interval_rad.has_value()); // of one run
}

// A sweep without variants has no such rows.
TEST(VariantTable, base_alone_has_no_rows)
{
    EXPECT_TRUE(variant_table(made_up_sweep(), {cells.begin(), cells.begin() + 4}).rows.empty());
}

// The texts hold the numbers above, rounded in Markdown, whole in CSV.
TEST(VariantTable, texts_hold_the_numbers)
{
    const Sweep sweep = made_up_sweep();
    const VariantTable table = variant_table(sweep, cells);
    const std::string markdown = variants_markdown(sweep, table);
    for (const char *expected :
         {"Without a change: CPG-H 3.50 rad over 2 objects, CPG-C 4.00 rad over 2 objects.\n",
          "| odd | `hand.pd_law = \"stable\"` | - | 0.00 (-6.00, -7.00 to -5.00) |\n",
          "| soft | `contact.friction = 0.25` | 7.00 (+3.50, 2.50 to 4.50) | 4.00 (the same runs) |\n",
          "| single | - | - | 2.50 (+0.50) |\n"}) {
        EXPECT_NE(markdown.find(expected), std::string::npos) << expected << "is not in\n" << markdown;
    }
    const std::string csv = variants_csv(sweep, table);
    for (const char *expected :
         {"# variant soft: contact.friction = 0.25\n", "odd,cpg-c,true,1,2,2,0,6,-6,-7,-5,false\n",
          "soft,cpg-h,true,2,4,4,7,3.5,3.5,2.5,4.5,false\n", "soft,cpg-c,true,2,4,4,4,4,0,",
          "single,cpg-c,true,1,1,2,2.5,2,0.5,,,false\n"}) {
        EXPECT_NE(csv.find(expected), std::string::npos) << expected << "is not in\n" << csv;
    }
}

} // namespace
