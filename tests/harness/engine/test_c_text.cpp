#include "engine/export/c_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace
{

using namespace twiddle::engine;

// By hand: 0.1 x 2^28 = 26843545.6, 9.81 x 2^24 = 164584488.96, 0.3 x 2^20 = 314572.8, 0.002 x 2^34 = 34359738.368;
// halves away from zero.
TEST(CText, constants_have_decimal_and_word)
{
    EXPECT_EQ(c_constant(CType::num, 0.1), "TWD_NUM_CONSTANT(0.1, 26843546)");
    EXPECT_EQ(c_constant(CType::wide, -9.81), "TWD_WIDE_CONSTANT(-9.81, -164584489)");
    EXPECT_EQ(c_constant(CType::rate, 0.3), "TWD_RATE_CONSTANT(0.3, 314573)");
    EXPECT_EQ(c_constant(CType::small, 0.002), "TWD_SMALL_CONSTANT(0.002, 34359738)");
    EXPECT_EQ(c_constant(CType::num, 0x1p-29), "TWD_NUM_CONSTANT(1.862645149230957e-09, 1)");
    EXPECT_EQ(c_constant(CType::num, -0x1p-29), "TWD_NUM_CONSTANT(-1.862645149230957e-09, -1)");
    EXPECT_EQ(c_constant(CType::num, -2), "TWD_NUM(-2)");
    EXPECT_EQ(c_constant(CType::rate, 20), "TWD_RATE(20)");
}

// What a format does not reach is at its end, also a whole number: 8, 128, 2048 and 0.125 are each one step too far.
TEST(CText, constants_beyond_a_format_are_at_its_end)
{
    EXPECT_EQ(c_constant(CType::num, 8), "TWD_NUM_CONSTANT(8, 2147483647)");
    EXPECT_EQ(c_constant(CType::wide, -128), "TWD_WIDE_CONSTANT(-128, -2147483647)");
    EXPECT_EQ(c_constant(CType::rate, 1e30), "TWD_RATE_CONSTANT(1e+30, 2147483647)");
    EXPECT_EQ(c_constant(CType::small, 0.125), "TWD_SMALL_CONSTANT(0.125, 2147483647)");
    EXPECT_FALSE(fixed_build_reaches(CType::num, 8));
    EXPECT_FALSE(fixed_build_reaches(CType::num, -8));
    EXPECT_TRUE(fixed_build_reaches(CType::num, 7.99999999));
    EXPECT_TRUE(fixed_build_reaches(CType::wide, 8));
}

// 10,000 words, as doubles, come back as themselves, and so do the decimals beside them.
TEST(CText, words_of_the_fixed_build_come_back)
{
    std::mt19937 random(20110824);
    for (int i = 0; i < 10000; ++i) {
        const auto word = static_cast<std::int32_t>(random() / 2) - (1 << 30);
        const double value = word / 268435456.0;
        if (value == std::trunc(value)) continue;
        const std::string text = c_constant(CType::num, value);
        const std::size_t comma = text.find(", ");
        EXPECT_EQ(std::stod(text.substr(text.find('(') + 1)), value);
        EXPECT_EQ(std::stol(text.substr(comma + 2)), word);
    }
}

TEST(CText, lists_keep_their_lines_short)
{
    EXPECT_EQ(c_list({"1", "2"}, "  "), "  1, 2,\n");
    EXPECT_EQ(c_list({}, "  "), "");
    const std::string a(70, 'a');
    const std::string b(45, 'b'); // both with comma, space and indent: 120 columns
    EXPECT_EQ(c_list({a, b, "c"}, "  "), "  " + a + ", " + b + ",\n  c,\n");
    EXPECT_EQ(c_list({a, b + "b"}, "  "), "  " + a + ",\n  " + b + "b,\n");
    EXPECT_EQ(c_list({std::string(200, 'a')}, "  "), "  " + std::string(200, 'a') + ",\n");
}

TEST(CText, comments_cannot_be_left)
{
    EXPECT_EQ(c_comment_text("a*/b\nc/*d/*/e"), "a* /b c/ *d/ * /e");
}

TEST(CText, fields_are_filled)
{
    EXPECT_EQ(fill("@a@ and @b@@a@", {{"a", "1"}, {"b", "@a@"}}), "1 and @a@1");
    EXPECT_EQ(fill("nothing", {}), "nothing");
    EXPECT_THROW(fill("@c@", {{"a", "1"}}), std::logic_error);
    EXPECT_THROW(fill("@a", {{"a", "1"}}), std::logic_error);
}

TEST(CText, names_are_those_of_c_and_cplusplus)
{
    for (const char *name : {"a", "small_sphere_cpg_h", "X1"}) {
        EXPECT_TRUE(is_c_name(name)) << name;
    }
    for (const char *name : {"", "1a", "_a", "a_", "a__b", "a-b", "a b", "\xc3\xa4"}) {
        EXPECT_FALSE(is_c_name(name)) << name;
    }
    EXPECT_TRUE(is_c_name(std::string(40, 'a')));
    EXPECT_FALSE(is_c_name(std::string(41, 'a')));
}

} // namespace
