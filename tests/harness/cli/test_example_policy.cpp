// The policy of firmware/examples, trained again as `make example-policy` does.
#include "../scratch_folder.hpp"
#include "program.hpp"
#include "record/csv_columns.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace
{

using namespace twiddle::test;

// 32-bit FNV-1a over the words of the desired angles of trajectory.csv, row by row: what the example `play` says of its
// own.
std::string checksum_of_desired_angles(const std::filesystem::path &trajectory)
{
    const auto joints = twiddle::record::read_csv_columns(
        trajectory, {"desired_fei_rad", "desired_aai_rad", "desired_fet_rad", "desired_ot_rad"});
    std::uint32_t sum = 0x811C9DC5;
    for (std::size_t row = 0; row < joints[0].size(); ++row) {
        for (const auto &joint : joints) {
            const auto word = static_cast<std::uint32_t>(static_cast<std::int32_t>(joint[row] * 0x1p28));
            for (unsigned bits = 0; bits < 32; bits += 8) {
                sum = (sum ^ ((word >> bits) & 0xFFU)) * 0x01000193U;
            }
        }
    }
    char text[9];
    std::snprintf(text, sizeof text, "%08X", static_cast<unsigned>(sum));
    return text;
}

// The committed header is what training and export write today, and the example that plays it wants, tick for tick, the
// angles of the run's own replay. On other processors the physics may round another way, and so teach another policy.
TEST(ExamplePolicy, committed_header_is_current_and_played_as_the_replay)
{
#if !defined(__x86_64__)
    GTEST_SKIP() << "the committed policy was trained on x86-64";
#endif
    const ScratchFolder folder;
    const std::string run = (folder.path() / "run").string();
    const std::string play = (folder.path() / "play.txt").string();
    const Outcome trained =
        run_twiddle("train --object small-sphere --model cpg-h --seed 1 --trials 2000 --number fixed --out " + run);
    ASSERT_EQ(trained.status, 0) << trained.error;
    const Outcome exported = run_twiddle("export " + run + " --c-header --name example");
    EXPECT_EQ(exported.status, 0) << exported.error;
    EXPECT_EQ(exported.output, text_of(TWIDDLE_EXAMPLE_POLICY)) << "make example-policy writes it again";

    ASSERT_EQ(run_twiddle("replay " + run).status, 0);
    ASSERT_EQ(std::system((TWIDDLE_EXAMPLE_PLAY " >" + play).c_str()), 0);
    const std::string expected =
        "checksum of desired angles " + checksum_of_desired_angles(run + "/trajectory.csv") + "\n";
    EXPECT_NE(text_of(play).find(expected), std::string::npos) << expected << text_of(play);
}

} // namespace
