#include "../scratch_folder.hpp"
#include "record/csv.hpp"
#include "record/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <random>

namespace
{

using namespace twiddle::record;
using twiddle::test::error_of;
using twiddle::test::is_one_sentence_with;
using twiddle::test::ScratchFolder;

std::string text_of(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

template <class To, class From> To bits_as(From from)
{
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(&to, &from, sizeof to);
    return to;
}

// Random bit patterns of every exponent come back from their text as the same number. Expected: the number
// itself, read by strtod.
TEST(Csv, numbers_read_back_as_they_were)
{
    const std::uint64_t seed = 20110824;
    std::mt19937_64 random(seed);
    for (int i = 0; i < 100000; ++i) {
        const auto value = bits_as<double>(static_cast<std::uint64_t>(random()));
        const auto small = bits_as<float>(static_cast<std::uint32_t>(random()));
        if (!(std::abs(value) <= std::numeric_limits<double>::max()) || !(std::abs(small) <= 3e38F)) continue;
        ASSERT_EQ(std::strtod(number_text(value).c_str(), nullptr), value) << "seed " << seed << ", case " << i;
        ASSERT_EQ(std::strtof(number_text(double{small}, "float").c_str(), nullptr), small)
            << "seed " << seed << ", case " << i;
        ASSERT_EQ(parse_number(number_text(value)), value) << "seed " << seed << ", case " << i;
    }
}

// Text that is not wholly one number is none. Expected: by the definition of the two formats.
TEST(Csv, text_that_is_no_number_is_refused)
{
    for (const char *text : {"", " 1", "1 ", "1,5", "0x10", "one", "+1", "1e"}) {
        EXPECT_FALSE(parse_number(text)) << text;
    }
    for (const char *text : {"", "-1", "1.0", "1e3", "18446744073709551616"}) {
        EXPECT_FALSE(parse_whole_number(text)) << text;
    }
    EXPECT_EQ(parse_whole_number("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
}

// Comments, header and rows stand in the file as given. Expected: written by hand.
TEST(Csv, file_has_comments_header_and_rows)
{
    const ScratchFolder folder;
    const auto path = folder.path() / "table.csv";
    CsvWriter writer(path, {"what it is", "seed: 3"}, {"step", "time_s"});
    writer.write(CsvRow().cell(std::uint64_t{1}).cell(0.01));
    writer.comment("a remark");
    writer.blank_line();
    writer.write(CsvRow().cell(std::uint64_t{2}).cell(0.5, "float"));
    writer.finish();
    EXPECT_EQ(text_of(path), "# what it is\n# seed: 3\nstep,time_s\n1,0.01\n# a remark\n\n2,0.5\n");
    EXPECT_FALSE(std::filesystem::exists(part_path(path)));
}

// Until finish(), an older table keeps its name and text, and every row so far is in the part file. Expected:
// both texts, by hand.
TEST(Csv, unfinished_table_does_not_take_the_name)
{
    const ScratchFolder folder;
    const auto path = folder.write("table.csv", "old\n");
    {
        CsvWriter writer(path, {}, {"a"});
        writer.write(CsvRow().cell(1.5));
        EXPECT_EQ(text_of(part_path(path)), "a\n1.5\n");
    }
    EXPECT_EQ(text_of(path), "old\n");
    EXPECT_EQ(text_of(part_path(path)), "a\n1.5\n");
}

// A table that was cut in the middle of a row goes on after its last whole row. Expected: the uncut table.
TEST(Csv, cut_table_goes_on_after_its_last_whole_row)
{
    const ScratchFolder folder;
    const auto path = folder.path() / "table.csv";
    folder.write("table.csv.part", "# what\na,b\n1,2\n# remark\n3,4\n5,");
    const CsvPart part = read_csv_part(path);
    EXPECT_EQ(part.header, "a,b");
    ASSERT_EQ(part.lines.size(), 3U);
    EXPECT_EQ(part.lines[1].text, "# remark");
    EXPECT_TRUE(part.lines[1].comment);
    EXPECT_EQ(part.lines[2].text, "3,4");

    CsvWriter writer(path, {"a", "b"}, part.lines[2].offset);
    writer.write(CsvRow().cell(3.0).cell(4.0));
    writer.write(CsvRow().cell(5.0).cell(6.0));
    writer.finish();
    EXPECT_EQ(text_of(path), "# what\na,b\n1,2\n# remark\n3,4\n5,6\n");
}

// A row with a missing value is a mistake of the program and never reaches the file.
TEST(Csv, row_must_have_one_value_a_column)
{
    const ScratchFolder folder;
    CsvWriter writer(folder.path() / "table.csv", {}, {"a", "b"});
    EXPECT_THROW(writer.write(CsvRow().cell(1.0)), std::logic_error);
    EXPECT_EQ(text_of(folder.path() / "table.csv.part"), "a,b\n");
}

// A file that cannot be written is named: in a folder that is not there, and on a full disk (/dev/full).
TEST(Csv, file_that_cannot_be_written_is_named)
{
    const ScratchFolder folder;
    EXPECT_TRUE(is_one_sentence_with(error_of([&] { CsvWriter(folder.path() / "no" / "t.csv", {}, {"a"}); }),
                                     {"cannot write", "no/t.csv.part"}));
    std::filesystem::create_symlink("/dev/full", folder.path() / "t.csv.part");
    EXPECT_TRUE(is_one_sentence_with(error_of([&] { CsvWriter(folder.path() / "t.csv", {}, {"a"}); }),
                                     {"cannot write", "t.csv.part"}));
}

} // namespace
