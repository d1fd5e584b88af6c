#include "../scratch_folder.hpp"
#include "claims/run_measures.hpp"
#include "program.hpp"
#include "record/csv.hpp"
#include "record/csv_columns.hpp"
#include "record/json_file.hpp"
#include "record/policy_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;
using Json = twiddle::record::Json;

constexpr int trials = 100;

// A made-up run on the small sphere: what its files hold.
struct MadeUpRun {
    std::string model;
    int seed;
    double rotation_rad;    // of every trial
    double frequency_share; // of the range 0.5 to 1.5 Hz
    double thumb_n;         // while the index presses with 1 N
    double lag_turns;       // of OT behind AAI
};

const std::vector<MadeUpRun> runs = {{"cpg-h", 1, 3, 0.5, 1, 0.5},     {"cpg-h", 2, 3.1, 0.6, 1, 0.46},
                                     {"cpg-c", 1, 1, 0.5, 0, 0},       {"cpg-c", 2, 1.1, 0.5, 0.001, 0},
                                     {"cpg-m", 1, 1.2, 0.5, 0, 0},     {"cpg-m", 2, 1.3, 0.5, 0.001, 0},
                                     {"cpg-s", 1, 0.9, 0.5, 0.001, 0}, {"cpg-s", 2, 1, 0.5, 0, 0}};

std::string folder_of(const MadeUpRun &run)
{
    return "small-sphere/" + run.model + "/seed-" + std::to_string(run.seed);
}

std::string trials_text(const MadeUpRun &run)
{
    std::ostringstream text;
    text << "trial,rotation_rad,s_c,s_m,s_s\n";
    for (int trial = 1; trial <= trials; ++trial) {
        text << trial << ',' << run.rotation_rad << (run.model == "cpg-h" ? ",0.5,0.25,0.25\n" : ",0,0,1\n");
    }
    return text.str();
}

std::string trajectory_text(const MadeUpRun &run)
{
    std::ostringstream text;
    text << "# made up\ntime_s,desired_aai_rad,desired_ot_rad,object_rad,index_contact_n,thumb_contact_n\n";
    const double turn_rad = 2 * std::acos(-1.0);
    const double frequency_hz = run.model == "cpg-h" ? 0.5 + run.frequency_share : 1;
    for (int step = 1; step <= 300; ++step) {
        const double t = 0.01 * step;
        text << t << ',' << 0.1 * std::cos(turn_rad * frequency_hz * t) << ','
             << 1 + 0.5 * std::cos(turn_rad * (frequency_hz * t - run.lag_turns)) << ',' << t << ",1," << run.thumb_n
             << '\n';
    }
    return text.str();
}

// A whole sweep, as `twiddle sweep` leaves it.
void write_sweep(const ScratchFolder &folder)
{
    Json listed = Json::array();
    for (const MadeUpRun &run : runs) {
        const std::string name = folder_of(run);
        listed.push_back({{"folder", name},
                          {"variant", ""},
                          {"object", "small-sphere"},
                          {"model", run.model},
                          {"centre", true},
                          {"seed", run.seed}});
        const Json settings = {
            {"oscillators", {{"frequency_lower_hz", 0.5}, {"frequency_upper_hz", 1.5}, {"lone_frequency_hz", 1}}}};
        const Json json = {{"state", "complete"}, {"object", "small-sphere"}, {"model", run.model},
                           {"centre", true},      {"seed", run.seed},         {"trials", trials},
                           {"hand", "welded"},    {"stepper", "fast"},        {"number", "float"},
                           {"command", "none"},   {"setup", "mid-a"},         {"settings", settings}};
        folder.write(name + "/run.json", json.dump());
        folder.write(name + "/trials.csv", trials_text(run));
        folder.write(name + "/trajectory.csv", trajectory_text(run));
        twiddle::record::Policy policy;
        policy.model = run.model;
        policy.parameters = {{"cpg-c.frequency", run.frequency_share}};
        twiddle::record::write_policy(folder.path() / name / "policy.json", policy);
    }
    folder.write("sweep.json", Json{{"format", 1},
                                    {"sweep", "tiny"},
                                    {"version", "made-up 0.0"},
                                    {"trials", trials},
                                    {"setup", "mid-a"},
                                    {"runs", listed}}
                                   .dump());
}

using Row = std::map<std::string, std::string>;

// The rows of claims.csv by part.
std::map<std::string, Row> claims_in(const ScratchFolder &folder)
{
    const Outcome outcome = run_twiddle("summarize " + folder.path().string());
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    std::istringstream text(text_of(folder.path() / "claims.csv"));
    std::vector<std::string> columns;
    std::map<std::string, Row> rows;
    for (std::string line; std::getline(text, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> cells = twiddle::record::split_csv(line);
        if (columns.empty()) columns = cells;
        EXPECT_EQ(cells.size(), columns.size()) << line;
        Row row;
        for (std::size_t i = 0; i < cells.size() && i < columns.size(); ++i) {
            row[columns[i]] = cells[i];
        }
        rows[row["part"]] = row;
    }
    return rows;
}

// Expected, by hand: the fingers of CPG-H share the turning evenly in both runs; phases 0.5 and 0.46 turns apart;
// learned frequencies 1.0 and 1.1 Hz against 1.0 in a range of 1 Hz; CPG-H leads by mean and best; the smallest area
// gain is 3.05 - 1.25 rad.
TEST(SummarizeClaims, values_are_those_of_the_files)
{
    const ScratchFolder folder;
    write_sweep(folder);
    std::map<std::string, Row> rows = claims_in(folder);
    const std::vector<std::tuple<std::string, double, std::string>> expected = {
        {"2a", 1, "supported"},    {"2b", 1, "supported"},   {"3b", 1.8, "supported"},  {"6a", 0.5, "supported"},
        {"6b", 0.48, "undecided"}, {"7a", 0.5, "supported"}, {"8a", 0.05, "undecided"}, {"8b", 0.05, "undecided"}};
    for (const auto &[part, value, verdict] : expected) {
        EXPECT_NEAR(std::stod(rows[part]["value"]), value, 1e-5) << part;
        EXPECT_EQ(rows[part]["verdict"], verdict) << part;
    }
    EXPECT_EQ(rows["6c"]["verdict"], "supported");
    EXPECT_EQ(rows["6a"]["claim_verdict"], "undecided");
    EXPECT_EQ(rows["6a"]["runs"], "2");
    EXPECT_EQ(rows["2a"]["paper"].substr(0, 6), "0.5555");
    EXPECT_EQ(rows["1"]["missing"], "the sweep has none of the cells");
    EXPECT_EQ(rows["7b"]["verdict"], "not measured");
    EXPECT_NE(rows["7b"]["missing"].find("small-sphere/cpg-h/seed-1"), std::string::npos);
}

// Without trajectory.csv or policy.json of one run, what needs them is not measured and names the run; the rest stays.
TEST(SummarizeClaims, missing_files_are_named)
{
    const ScratchFolder folder;
    write_sweep(folder);
    fs::remove(folder.path() / folder_of(runs[1]) / "trajectory.csv");
    fs::remove(folder.path() / folder_of(runs[2]) / "policy.json");
    std::map<std::string, Row> rows = claims_in(folder);
    EXPECT_EQ(rows["6a"]["verdict"], "not measured");
    EXPECT_EQ(rows["6a"]["missing"],
              "1 of the runs lack trajectory.csv or a frequency; the first is " + folder_of(runs[1]));
    EXPECT_NE(rows["8a"]["missing"].find("policy.json"), std::string::npos);
    EXPECT_NE(rows["8a"]["missing"].find(folder_of(runs[2])), std::string::npos);
    EXPECT_EQ(rows["2a"]["verdict"], "supported");
    const std::string markdown = text_of(folder.path() / "claims.md");
    EXPECT_NE(markdown.find("Not measured: 1 of the runs lack trajectory.csv"), std::string::npos);
}

// A trajectory that is there and malformed is no missing one: it is named, and nothing is written.
TEST(SummarizeClaims, malformed_trajectory_is_named)
{
    const ScratchFolder folder;
    write_sweep(folder);
    folder.write(folder_of(runs[0]) + "/trajectory.csv", "time_s,object_rad\n0.01,0\n");
    const Outcome outcome = run_twiddle("summarize " + folder.path().string());
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
    EXPECT_NE(outcome.error.find("trajectory.csv' has no column 'index_contact_n'"), std::string::npos)
        << outcome.error;
    EXPECT_FALSE(fs::exists(folder.path() / "table1.csv"));
    EXPECT_FALSE(fs::exists(folder.path() / "claims.csv"));
}

// The same sweep gives the same bytes, and stands beside itself; a folder without claims.csv is wrong use.
TEST(SummarizeClaims, compare_claims_reads_what_summarize_wrote)
{
    const ScratchFolder folder;
    write_sweep(folder);
    const std::string name = folder.path().string();
    const Outcome early = run_twiddle("compare-claims " + name);
    EXPECT_EQ(early.status, 2);
    EXPECT_TRUE(is_one_complaint(early.error)) << early.error;
    EXPECT_NE(early.error.find("run summarize on it first"), std::string::npos) << early.error;

    claims_in(folder);
    const std::string csv = text_of(folder.path() / "claims.csv");
    const std::string markdown = text_of(folder.path() / "claims.md");
    claims_in(folder);
    EXPECT_EQ(text_of(folder.path() / "claims.csv"), csv);
    EXPECT_EQ(text_of(folder.path() / "claims.md"), markdown);

    const Outcome outcome = run_twiddle("compare-claims " + name + " " + name);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NE(outcome.output.find("| " + name + ", set-up mid-a | " + name + ", set-up mid-a | holds |"),
              std::string::npos);
    EXPECT_NE(outcome.output.find("supported | in every set-up |"), std::string::npos) << outcome.output;
}

// The largest change of any joint's desired angle from a time after 1.2 s, when amplitudes and centres have settled,
// to `later_s` on.
double largest_change_rad(const std::vector<std::vector<double>> &joints, double later_s)
{
    constexpr std::size_t settled = 120;
    const double steps = later_s / 0.01;
    const auto whole = static_cast<std::size_t>(steps);
    const double rest = steps - static_cast<double>(whole);
    double largest = 0;
    for (const std::vector<double> &angle_rad : joints) {
        for (std::size_t i = settled; i + whole + 1 < angle_rad.size(); ++i) {
            const double later_rad = (1 - rest) * angle_rad[i + whole] + rest * angle_rad[i + whole + 1];
            largest = std::max(largest, std::abs(later_rad - angle_rad[i]));
        }
    }
    return largest;
}

// The frequency that a run counts with is that of the angles it asks for: they repeat after its period, not after half
// of it. It is learned by CPG-C, and set for CPG-M alone.
TEST(SummarizeClaims, frequency_is_that_of_the_desired_angles)
{
    for (const std::string model : {"cpg-c", "cpg-m"}) {
        const ScratchFolder folder;
        const std::string run = (folder.path() / "run").string();
        ASSERT_EQ(
            run_twiddle("train --object small-sphere --model " + model + " --seed 3 --trials 20 --out " + run).status,
            0);
        ASSERT_EQ(run_twiddle("replay " + run).status, 0);
        const twiddle::results::Sweep sweep{"", "", 20, {}, {}};
        const auto measures =
            twiddle::claims::read_run_measures(folder.path(), sweep, {"run", "", "small-sphere", model, true, 3});
        ASSERT_TRUE(measures.frequency);
        const auto joints = twiddle::record::read_csv_columns(
            run + "/trajectory.csv", {"desired_fei_rad", "desired_aai_rad", "desired_fet_rad", "desired_ot_rad"});
        const double period_s = 1 / measures.frequency->value_hz;
        EXPECT_LT(largest_change_rad(joints, period_s), 0.005)
            << model << ", " << measures.frequency->value_hz << " Hz";
        EXPECT_GT(largest_change_rad(joints, period_s / 2), 0.1) << model;
    }
}

} // namespace
