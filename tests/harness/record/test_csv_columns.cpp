#include "../scratch_folder.hpp"
#include "record/csv_columns.hpp"

#include <gtest/gtest.h>

namespace
{

using namespace twiddle::test;
using twiddle::record::read_csv_columns;
using twiddle::record::read_csv_header;

using Columns = std::vector<std::vector<double>>;

// Columns come in the order asked for; remarks and empty lines are no rows; a cell that is not asked for
// may hold anything.
TEST(CsvColumns, chosen_columns_in_the_order_asked_for)
{
    const ScratchFolder folder;
    const auto path = folder.write("t.csv", "# what\na,b,c,d\n1,x,2.5,-3\n# remark\n\n4,,5e-1,6\n");
    EXPECT_EQ(read_csv_columns(path, {"d", "a", "c"}), (Columns{{-3, 6}, {1, 4}, {2.5, 0.5}}));
    EXPECT_EQ(read_csv_header(path), (std::vector<std::string>{"a", "b", "c", "d"}));
    EXPECT_EQ(read_csv_columns(folder.write("empty.csv", "a,b\n"), {"b"}), Columns{{}});
}

// What is wrong is said in one sentence with the file's name.
TEST(CsvColumns, malformed_tables_are_named)
{
    const ScratchFolder folder;
    const std::vector<std::pair<std::string, std::string>> cases = {{"a,b\n1,2\n", "has no column 'c'"},
                                                                    {"a,c\n1,2\n3\n", "has no valid row 2"},
                                                                    {"a,c\n1,2,3\n", "has no valid row 1"},
                                                                    {"a,c\n1,two\n", "has no valid row 1"},
                                                                    {"a,c\n1,nan\n", "has no valid row 1"},
                                                                    {"a,c\n1,\n", "has no valid row 1"},
                                                                    {"a,c\n1,2", "does not end with a whole line"},
                                                                    {"# nothing\n", "has no header row"}};
    for (const auto &[text, expected] : cases) {
        const auto path = folder.write("t.csv", text);
        const std::string error = error_of([&] { read_csv_columns(path, {"a", "c"}); });
        EXPECT_TRUE(is_one_sentence_with(error, {path.string(), expected})) << error;
    }
    EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_csv_columns(folder.path() / "none.csv", {"a"}); }),
                                     {"cannot read", "none.csv"}));
}

} // namespace
