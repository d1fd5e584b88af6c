#include "../scratch_folder.hpp"
#include "claims/claims_comparison.hpp"

#include <gtest/gtest.h>

namespace
{

using namespace twiddle::test;
using namespace twiddle::claims;

const std::string head = "# made up\nclaim,part,words,value,lower,upper,verdict,claim_verdict\n";

// What several verdicts come to.
TEST(ClaimsComparison, where_a_claim_holds)
{
    EXPECT_EQ(where_it_holds({"supported", "supported"}), "in every set-up");
    EXPECT_EQ(where_it_holds({"not supported", "not supported"}), "in none");
    EXPECT_EQ(where_it_holds({"supported", "undecided", "not supported"}), "set-up decides");
    EXPECT_EQ(where_it_holds({"supported", "undecided"}), "open");
    EXPECT_EQ(where_it_holds({"not supported", "not measured"}), "open");
}

// Two sweeps side by side: the whole claims first, then their parts with numbers.
TEST(ClaimsComparison, sweeps_stand_side_by_side)
{
    const ScratchFolder folder;
    const auto a = folder.write("a.csv", head + "1,1,words,0.5,0.25,0.75,supported,supported\n"
                                                "2,2a,more,1,,,not measured,not supported\n"
                                                "2,2b,most,,,,not supported,not supported\n");
    const auto b = folder.write("b.csv", head + "1,1,words,-1,-2,-0.5,not supported,not supported\n"
                                                "2,2a,more,2,1,3,supported,not supported\n"
                                                "2,2b,most,0,-1,-0.5,not supported,not supported\n");
    const std::string text = comparison_markdown({{"A", read_claims_csv(a)}, {"B", read_claims_csv(b)}});
    for (const char *line :
         {"| claim | the paper says | A | B | holds |\n", "| supported | not supported | set-up decides |\n",
          "| not supported | not supported | in none |\n",
          "| 1 | words | 0.500 (0.250 to 0.750) supported | -1.000 (-2.000 to -0.500) not supported | "
          "set-up decides |\n",
          "| 2a | more | 1.000 not measured | 2.000 (1.000 to 3.000) supported | open |\n",
          "| 2b | most | - not supported | 0.000 (-1.000 to -0.500) not supported | in none |\n"}) {
        EXPECT_NE(text.find(line), std::string::npos) << line << " is not in\n" << text;
    }
}

// Files that are no claims.csv, or of other parts, are refused in one sentence.
TEST(ClaimsComparison, other_files_are_refused)
{
    const ScratchFolder folder;
    for (const auto &[text, expected] : {std::pair(head, "holds no claims"),
                                         {head + "1,1,words\n", "has a row that is not whole"},
                                         {"claim,part\n1,1\n", "has no column 'lower'"}}) {
        const auto path = folder.write("c.csv", text);
        EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_claims_csv(path); }), {path.string(), expected}));
    }
    const auto one = read_claims_csv(folder.write("a.csv", head + "1,1,words,1,1,1,supported,supported\n"));
    const auto other = read_claims_csv(folder.write("b.csv", head + "1,1,others,1,1,1,supported,supported\n"));
    EXPECT_TRUE(is_one_sentence_with(error_of([&] {
                                         comparison_markdown({{"A", one}, {"B", other}});
                                     }),
                                     {"A and B", "different parts"}));
}

} // namespace
