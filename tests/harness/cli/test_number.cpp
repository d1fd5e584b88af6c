// The program on fixed-point numbers, beside the program on floats.
#include "../scratch_folder.hpp"
#include "program.hpp"
#include "record/csv.hpp"
#include "record/json_file.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;

const std::string skill = "--object small-sphere --model cpg-h ";
constexpr int trials = 20;

// A run of `trials` trials in `out`; its trials.csv.
std::string train(const fs::path &out, const std::string &number)
{
    const Outcome outcome = run_twiddle("train " + skill + "--seed 5 --trials " + std::to_string(trials) +
                                        " --number " + number + " --out " + out.string());
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return text_of(out / "trials.csv");
}

// The rows of a log of trials, without comments and header.
std::vector<std::vector<double>> rows_of(const std::string &text)
{
    std::vector<std::vector<double>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#' || line[0] == 't') continue;
        std::vector<double> &row = rows.emplace_back();
        for (const std::string &cell : twiddle::record::split_csv(line))
            row.push_back(std::stod(cell));
    }
    return rows;
}

// The same seed gives the same bytes, and the run says which numbers it used.
TEST(Number, fixed_run_gives_the_same_bytes)
{
    const ScratchFolder folder;
    const std::string text = train(folder.path() / "a", "fixed");
    EXPECT_NE(text.find("number type fixed"), std::string::npos);
    EXPECT_EQ(train(folder.path() / "b", "fixed"), text);
    EXPECT_EQ(text_of(folder.path() / "a" / "policy.json"), text_of(folder.path() / "b" / "policy.json"));
    EXPECT_EQ(twiddle::record::read_json(folder.path() / "a" / "run.json")["number"], "fixed");
    EXPECT_NE(train(folder.path() / "c", "float"), text);
}

// A run that was stopped half-way ends with the same bytes. Expected: the uninterrupted run's files.
TEST(Number, fixed_run_is_resumed)
{
    const ScratchFolder folder;
    const fs::path whole = folder.path() / "whole", cut = folder.path() / "cut";
    const std::string text = train(whole, "fixed");
    fs::create_directories(cut);
    std::ofstream(cut / "trials.csv.part") << text.substr(0, text.find("\n12,") + 1);
    twiddle::record::Json run = twiddle::record::read_json(whole / "run.json");
    run["state"] = "running";
    run.erase("summary");
    twiddle::record::write_json(cut / "run.json", run);
    const Outcome outcome = run_twiddle("train " + skill + "--seed 5 --trials " + std::to_string(trials) +
                                        " --number fixed --resume --out " + cut.string());
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(text_of(cut / "trials.csv"), text);
    EXPECT_EQ(text_of(cut / "policy.json"), text_of(whole / "policy.json"));
}

// With the same seed the two number types draw the same noise, so that their runs begin alike: trial by trial, the same
// noise and weights but for rounding, and the same rotations but for what rounding makes of them in 3 s.
TEST(Number, fixed_and_float_runs_begin_alike)
{
    const ScratchFolder folder;
    const auto in_fixed = rows_of(train(folder.path() / "fixed", "fixed"));
    const auto in_float = rows_of(train(folder.path() / "float", "float"));
    ASSERT_EQ(in_fixed.size(), std::size_t{trials});
    ASSERT_EQ(in_float.size(), std::size_t{trials});
    for (std::size_t i = 0; i < trials; ++i) {
        // trial, rotation_rad, reward, value, td_error; noise, s_c, s_m, s_s
        ASSERT_EQ(in_fixed[i].size(), std::size_t{9});
        ASSERT_EQ(in_float[i].size(), std::size_t{9});
        for (std::size_t column = 0; column < 9; ++column)
            EXPECT_NEAR(in_fixed[i][column], in_float[i][column], column < 5 ? 1e-3 : 1e-6) << i << ", " << column;
    }
}

// Parameters nearer to 0 and 1 than a step of the fixed-point numbers are taken, as 0 and 1. Expected: the
// float's rotation.
TEST(Number, fixed_rollout_takes_what_is_next_to_the_ends)
{
    const std::string lines = "0.999999999999,0.5\n1e-12,0.5\n0.9,0.3\n";
    const std::string rollout = "rollout --object small-sphere --model cpg-s ";
    const Outcome in_fixed = run_twiddle(rollout + "--number fixed", lines);
    const Outcome in_float = run_twiddle(rollout, lines);
    EXPECT_EQ(in_fixed.status, 0) << in_fixed.error;
    EXPECT_EQ(in_fixed.error, "");
    std::istringstream found(in_fixed.output), expected(in_float.output);
    for (int line = 0; line < 3; ++line) {
        double rotation_rad = -1, expected_rad = 1;
        found >> rotation_rad;
        expected >> expected_rad;
        EXPECT_NEAR(rotation_rad, expected_rad, 1e-3) << line;
    }
}

} // namespace
