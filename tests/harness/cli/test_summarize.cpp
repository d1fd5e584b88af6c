#include "../scratch_folder.hpp"
#include "program.hpp"
#include "record/csv.hpp"
#include "record/json_file.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;
using Json = twiddle::record::Json;

// The runs of one cell: seeds 1, 2, ... with these mean rotations over the last trials, in rad.
struct MadeUpCell {
    std::string variant;
    std::string object;
    std::string model;
    bool centre;
    std::vector<double> mean_rad;

    std::string folder(std::size_t seed) const
    {
        return (variant.empty() ? "" : variant + "/") + object + "/" + model + (centre ? "" : "-no-centre") + "/seed-" +
               std::to_string(seed);
    }
};

// The last 500 rotations (or all, if there are fewer) are in turn mean - 1 and mean + 1; those before,
// 99, must not count.
std::string trials_text(std::size_t trials, double mean_rad)
{
    std::ostringstream text;
    text << "# made-up numbers\ntrial,rotation_rad,reward\n";
    for (std::size_t trial = 1; trial <= trials; ++trial) {
        text << trial << ',' << (trial + 500 <= trials ? 99 : mean_rad + (trial % 2 == 0 ? 1 : -1)) << ",0\n";
    }
    return text.str();
}

Json run_json(const MadeUpCell &cell, std::size_t seed, std::size_t trials)
{
    return {{"state", "complete"},   {"object", cell.object}, {"model", cell.model},
            {"centre", cell.centre}, {"seed", seed},          {"trials", trials},
            {"hand", "welded"},      {"stepper", "fast"},     {"number", "float"},
            {"command", "none"},     {"setup", "mid-a"},      {"settings", {{"contact", {{"friction", 0.8}}}}}};
}

void write_sweep(const ScratchFolder &folder, std::size_t trials, const std::vector<MadeUpCell> &cells)
{
    Json runs = Json::array();
    for (const MadeUpCell &cell : cells) {
        for (std::size_t seed = 1; seed <= cell.mean_rad.size(); ++seed) {
            const std::string run = cell.folder(seed);
            runs.push_back({{"index", runs.size()},
                            {"folder", run},
                            {"object", cell.object},
                            {"model", cell.model},
                            {"centre", cell.centre},
                            {"seed", seed},
                            {"variant", cell.variant}});
            folder.write(run + "/run.json", run_json(cell, seed, trials).dump(2));
            folder.write(run + "/trials.csv", trials_text(trials, cell.mean_rad[seed - 1]));
        }
    }
    const Json sweep = {{"format", 1},      {"sweep", "tiny"},  {"version", "made-up 0.0"},
                        {"trials", trials}, {"setup", "mid-a"}, {"runs", runs}};
    folder.write("sweep.json", sweep.dump(2));
}

const std::vector<MadeUpCell> tiny = {{"", "small-sphere", "cpg-c", true, {1, 2, 3, 4}},
                                      {"", "small-sphere", "cpg-h", true, {5, 6, 7, 8}},
                                      {"", "small-sphere", "cpg-s", true, {4.5, 5.5, 6.5, 7.5}},
                                      {"", "small-sphere", "cpg-h", false, {0, 1, 2, 3}}};

Outcome summarize(const ScratchFolder &folder)
{
    return run_twiddle("summarize " + folder.path().string());
}

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const fs::path &path)
{
    std::istringstream text(text_of(path));
    std::vector<std::string> columns;
    std::vector<Row> rows;
    for (std::string line; std::getline(text, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> cells = twiddle::record::split_csv(line);
        if (columns.empty()) {
            columns = cells;
            continue;
        }
        EXPECT_EQ(cells.size(), columns.size()) << line;
        Row row;
        for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i) {
            row[columns[i]] = cells[i];
        }
        rows.push_back(row);
    }
    return rows;
}

void expect_numbers(Row row, const std::vector<std::pair<std::string, double>> &expected)
{
    for (const auto &[column, value] : expected) {
        ASSERT_FALSE(row[column].empty()) << column;
        EXPECT_NEAR(std::stod(row[column]), value, 1e-12) << column;
    }
}

void expect_texts(Row row, const std::vector<std::pair<std::string, std::string>> &expected)
{
    for (const auto &[column, value] : expected) {
        EXPECT_EQ(row[column], value) << column;
    }
}

// The command must fail with `status` and each of `parts` in its one sentence, and write no table.
void expect_refusal(const ScratchFolder &folder, int status, std::initializer_list<std::string> parts)
{
    const Outcome outcome = summarize(folder);
    EXPECT_EQ(outcome.status, status);
    EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
    for (const std::string &part : parts) {
        EXPECT_NE(outcome.error.find(part), std::string::npos) << "'" << part << "' is not in: " << outcome.error;
    }
    for (const char *table : {"table1.csv", "table2.csv", "tables.md", "table1.csv.part"}) {
        EXPECT_FALSE(fs::exists(folder.path() / table)) << table;
    }
    EXPECT_FALSE(fs::exists(folder.path() / "figures"));
}

// Table 1. Expected, by hand: of 5, 6, 7, 8 the standard deviation is sqrt(5 / 3); of the 256 resamples' sums 5 lie
// below 22, 15 below 23, hence the interval 22/4 to 30/4; all of one cell above all of the other is 2 of 70
// arrangements. The paper's values are read from its printed table.
TEST(Summarize, table1_is_with_beside_without_centre)
{
    const ScratchFolder folder;
    write_sweep(folder, 502, tiny);
    const Outcome outcome = summarize(folder);
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    const std::vector<Row> rows = rows_of(folder.path() / "table1.csv");
    ASSERT_EQ(rows.size(), 2U);
    expect_texts(rows[0], {{"variant", ""},
                           {"object", "small-sphere"},
                           {"model", "cpg-h"},
                           {"centre", "true"},
                           {"runs", "4"},
                           {"p", ""},
                           {"paper_reward", "5.692"}});
    expect_numbers(
        rows[0],
        {{"mean_rad", 6.5}, {"sd_rad", 1.2909944487358056}, {"best_rad", 8}, {"lower_rad", 5.5}, {"upper_rad", 7.5}});
    expect_texts(rows[1], {{"model", "cpg-h"}, {"centre", "false"}, {"paper_reward", "2.829"}});
    expect_numbers(rows[1],
                   {{"mean_rad", 1.5}, {"best_rad", 3}, {"lower_rad", 0.5}, {"upper_rad", 2.5}, {"p", 2.0 / 70}});
    EXPECT_NE(text_of(folder.path() / "table1.csv").find("the last 500 of 502 trials"), std::string::npos);
}

// Table 2. Expected, by hand: cpg-s lies below cpg-h in 10 of 16 pairs, and 1 + 1 + 2 + 3 + 5 + 5 + 7 = 24 of 70
// arrangements have a U of at most 6; Holm doubles the smaller of two p and leaves the other.
TEST(Summarize, table2_has_the_winner_and_its_tests)
{
    const ScratchFolder folder;
    write_sweep(folder, 502, tiny);
    ASSERT_EQ(summarize(folder).status, 0);
    const std::vector<Row> rows = rows_of(folder.path() / "table2.csv");
    ASSERT_EQ(rows.size(), 3U);
    expect_texts(rows[0], {{"model", "cpg-s"}, {"winner", "false"}, {"paper_mean", "3.981"}, {"paper_sd", "0.018"}});
    expect_numbers(rows[0], {{"mean_rad", 6}, {"p", 48.0 / 70}, {"p_holm", 48.0 / 70}});
    expect_texts(rows[1], {{"model", "cpg-c"}, {"winner", "false"}, {"paper_best", "5.361"}});
    expect_numbers(rows[1], {{"mean_rad", 2.5}, {"p", 2.0 / 70}, {"p_holm", 4.0 / 70}});
    expect_texts(rows[2], {{"model", "cpg-h"}, {"winner", "true"}, {"p", ""}, {"p_holm", ""}, {"paper_best", "5.773"}});

    const std::string markdown = text_of(folder.path() / "tables.md");
    for (const char *line :
         {"| - | small-sphere | CPG-H without centre | 1.500 ± 1.291 (3.000) | 0.500 to 2.500 | 4 | 0.0286 | 2.829 |\n",
          "| - | small-sphere | CPG-C | 2.500 ± 1.291 (4.000) | 1.500 to 3.500 | 4 | 0.0571 (0.0286) | 4.508 ± 1.207 "
          "(5.361) |\n",
          "| - | small-sphere | CPG-H | 6.500 ± 1.291 (8.000) | 5.500 to 7.500 | 4 | winner | 5.686 ± 0.063 (5.773) "
          "|\n",
          "these numbers of runs can give, without ties, is 0.0571.\n"}) {
        EXPECT_NE(markdown.find(line), std::string::npos) << line << " is not in\n" << markdown;
    }
}

// The figures' data come with the tables. Expected, by hand: of 502 trials the first point's two are 99 and 48 are in
// turn one below and one above the run's mean; the last point has two trials, one below and one above. What the columns
// hold: test_figure_data.
TEST(Summarize, figures_have_their_data)
{
    const ScratchFolder folder;
    write_sweep(folder, 502, tiny);
    const Outcome outcome = summarize(folder);
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const fs::path data = folder.path() / "figures" / "data";
    EXPECT_NE(outcome.output.find((data / "learning_curves.csv").string()), std::string::npos) << outcome.output;
    const std::vector<Row> curves = rows_of(data / "learning_curves.csv");
    ASSERT_EQ(curves.size(), 4 * 11U);
    expect_texts(curves[0], {{"object", "small-sphere"}, {"model", "cpg-c"}, {"centre", "true"}, {"runs", "4"}});
    expect_numbers(curves[0], {{"trial", 25.5},
                               {"mean_rad", (2 * 99 + 48 * 2.5) / 50},
                               {"sd_rad", 1.2909944487358056 * 48 / 50},
                               {"best_run_rad", (2 * 99 + 48 * 4.0) / 50}});
    expect_numbers(curves[10], {{"trial", 501.5}, {"mean_rad", 2.5}, {"best_run_rad", 4}});
    const std::vector<Row> best = rows_of(data / "best_runs.csv");
    ASSERT_EQ(best.size(), 4 * 2U);
    expect_texts(best[2], {{"model", "cpg-h"}, {"rank", "1"}, {"seed", "4"}, {"folder", "small-sphere/cpg-h/seed-4"}});
    expect_numbers(best[3], {{"rank", 2}, {"seed", 3}, {"rotation_rad", 7}});
}

// The same sweep gives the same bytes.
TEST(Summarize, same_sweep_gives_the_same_bytes)
{
    const ScratchFolder folder;
    write_sweep(folder, 10, tiny);
    std::vector<std::string> texts;
    for (int time = 0; time < 2; ++time) {
        ASSERT_EQ(summarize(folder).status, 0);
        for (const char *table : {"table1.csv", "table2.csv", "tables.md"}) {
            texts.push_back(text_of(folder.path() / table));
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(texts[i], texts[i + 3]);
    }
}

// Runs with fewer than 500 trials count with all of them, and the tables say so. A single run has no spread.
TEST(Summarize, short_runs_count_with_all_their_trials)
{
    const ScratchFolder folder;
    write_sweep(folder, 4, {{"", "large-cube", "cpg-m", true, {2.5}}});
    ASSERT_EQ(summarize(folder).status, 0);
    const std::vector<Row> rows = rows_of(folder.path() / "table2.csv");
    ASSERT_EQ(rows.size(), 1U);
    expect_texts(rows[0], {{"runs", "1"}, {"mean_rad", "2.5"}, {"sd_rad", ""}, {"lower_rad", ""}, {"winner", "false"}});
    EXPECT_TRUE(rows_of(folder.path() / "table1.csv").empty());
    for (const char *table : {"table1.csv", "table2.csv", "tables.md"}) {
        EXPECT_NE(text_of(folder.path() / table).find("all 4 trials"), std::string::npos) << table;
    }
}

// A variant has rows of its own, after those of the sweep's own settings; objects stand in the paper's order.
TEST(Summarize, variants_and_objects_have_rows_of_their_own)
{
    const ScratchFolder folder;
    write_sweep(folder, 4,
                {{"", "medium-cube", "cpg-h", true, {1, 2}},
                 {"", "small-cube", "cpg-h", true, {3, 4}},
                 {"friction-0.4", "small-cube", "cpg-h", true, {5, 6}},
                 {"friction-0.4", "small-cube", "cpg-s", false, {7, 8}}});
    ASSERT_EQ(summarize(folder).status, 0);
    std::string order;
    for (Row row : rows_of(folder.path() / "table1.csv")) {
        order += row["variant"] + " " + row["object"] + " " + row["model"] + " " + row["mean_rad"] + " " +
                 row["paper_reward"] + "\n";
    }
    EXPECT_EQ(order, " small-cube cpg-h 3.5 3.714\n medium-cube cpg-h 1.5 3.700\n"
                     "friction-0.4 small-cube cpg-h 5.5 3.714\nfriction-0.4 small-cube cpg-s 7.5 \n");
    EXPECT_EQ(rows_of(folder.path() / "table2.csv").size(), 3U);
}

// A sweep with variants gets their table too, with what each changes; one without has none.
TEST(Summarize, variants_have_a_table_beside_the_base)
{
    const ScratchFolder folder;
    write_sweep(folder, 4, {{"", "small-cube", "cpg-h", true, {3, 5}}, {"soft", "small-cube", "cpg-h", true, {5, 6}}});
    Json sweep = twiddle::record::read_json(folder.path() / "sweep.json");
    sweep["variants"] = {{"soft", {{"contact.friction", 0.25}, {"oscillators.phase_start", "zero"}}}};
    folder.write("sweep.json", sweep.dump());
    ASSERT_EQ(summarize(folder).status, 0);
    const std::vector<Row> rows = rows_of(folder.path() / "choices.csv");
    ASSERT_EQ(rows.size(), 1U);
    expect_texts(rows[0], {{"variant", "soft"}, {"model", "cpg-h"}, {"objects", "1"}, {"same_runs", "false"}});
    expect_numbers(rows[0], {{"mean_rad", 5.5}, {"base_mean_rad", 4}, {"difference_rad", 1.5}});
    const std::string markdown = text_of(folder.path() / "choices.md");
    EXPECT_NE(markdown.find("| soft | `contact.friction = 0.25, oscillators.phase_start = \"zero\"` | 5.50 (+1.50, "),
              std::string::npos)
        << markdown;

    const ScratchFolder plain;
    write_sweep(plain, 4, tiny);
    ASSERT_EQ(summarize(plain).status, 0);
    EXPECT_FALSE(fs::exists(plain.path() / "choices.csv"));
}

// Tables that cannot be written leave those of before as they were. 1 block is less than any of them.
TEST(Summarize, full_disk_leaves_the_old_tables)
{
    const ScratchFolder folder;
    write_sweep(folder, 4, tiny);
    ASSERT_EQ(summarize(folder).status, 0);
    const std::string before = text_of(folder.path() / "table1.csv");
    const Outcome outcome = run_twiddle_on_full_disk("summarize " + folder.path().string(), 1);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
    EXPECT_NE(outcome.error.find("table1.csv.part': File too large"), std::string::npos) << outcome.error;
    EXPECT_EQ(text_of(folder.path() / "table1.csv"), before);
}

// Runs that are missing, still running or without trials.csv are counted, and the first five are named.
TEST(Summarize, incomplete_sweep_is_refused)
{
    const ScratchFolder folder;
    write_sweep(folder, 4, tiny);
    fs::remove(folder.path() / tiny[0].folder(2) / "trials.csv");
    Json running = run_json(tiny[1], 1, 4);
    running["state"] = "running";
    folder.write(tiny[1].folder(1) + "/run.json", running.dump());
    expect_refusal(folder, 1, {"2 of 16 runs", tiny[0].folder(2) + ", " + tiny[1].folder(1) + ";"});
    fs::remove_all(folder.path() / "small-sphere" / "cpg-h-no-centre");
    expect_refusal(folder, 1, {"6 of 16 runs", tiny[3].folder(3) + ", ...;"});
}

// A log that is not the run's whole one is named with what is wrong.
TEST(Summarize, corrupt_log_is_named)
{
    const std::string head = "# made-up numbers\ntrial,rotation_rad,reward\n";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {head + "1,0.5,0\n2,0.5,0\n", "has 2 trials where the run has 3"},
        {head + "1,0.5,0\n2,0.5,0\n3,0.5,0\n4,0.5,0\n", "has 4 trials where the run has 3"},
        {head + "1,0.5,0\n2,0.5,0\n3,0.5,0", "does not end with a whole line"},
        {head + "1,0.5,0\n3,0.5,0\n3,0.5,0\n", "has no valid row 2"},
        {head + "1,0.5,0\n2,half,0\n3,0.5,0\n", "has no valid row 2"},
        {head + "1,0.5,0\n2,nan,0\n3,0.5,0\n", "has no valid row 2"},
        {head + "1,0.5,0\n2,0.5,0\n3,0.5\n", "has no valid row 3"},
        {head + "1,0.5,0,7\n2,0.5,0\n3,0.5,0\n", "has no valid row 1"},
        {"trial,reward\n1,0.5\n2,0.5\n3,0.5\n", "has no column 'rotation_rad'"},
        {"rotation_rad,reward\n1,0.5\n2,0.5\n3,0.5\n", "has no column 'trial'"},
        {"# nothing\n", "has no header row"},
        {"", "has no header row"}};
    for (const auto &[text, expected] : cases) {
        const ScratchFolder folder;
        write_sweep(folder, 3, tiny);
        const std::string name = tiny[1].folder(3) + "/trials.csv";
        folder.write(name, text);
        expect_refusal(folder, 1, {"'" + (folder.path() / name).string() + "' " + expected});
    }
}

// A remark below a trial, as train writes it of a fault, is no row.
TEST(Summarize, remark_in_a_log_is_no_row)
{
    const ScratchFolder folder;
    write_sweep(folder, 2, {{"", "small-cube", "cpg-c", true, {3}}});
    folder.write("small-cube/cpg-c/seed-1/trials.csv", "trial,rotation_rad\n1,0\n# fault: made up\n2,5\n");
    ASSERT_EQ(summarize(folder).status, 0);
    EXPECT_EQ(rows_of(folder.path() / "table2.csv")[0]["mean_rad"], "2.5");
}

// A run.json of another run, or with other settings than its cell's first, is named.
TEST(Summarize, run_of_other_settings_is_named)
{
    const std::vector<std::pair<Json, std::string>> cases = {
        {{{"seed", 4}}, "is of another run"},
        {{{"object", "small-cube"}}, "is of another run"},
        {{{"centre", false}}, "is of another run"},
        {{{"trials", 4}}, "is of another run"},
        {{{"stepper", "reference"}}, "has other settings"},
        {{{"settings", {{"contact", {{"friction", 0.4}}}}}}, "has other settings"},
        {{{"state", "done"}}, "'state' must be"}};
    for (const auto &[changes, expected] : cases) {
        const ScratchFolder folder;
        write_sweep(folder, 3, tiny);
        Json run = run_json(tiny[1], 3, 3);
        run.update(changes);
        folder.write(tiny[1].folder(3) + "/run.json", run.dump());
        expect_refusal(folder, 1, {(folder.path() / tiny[1].folder(3) / "run.json").string(), expected});
    }
}

// A folder without sweep.json is wrong use; a sweep.json that does not hold what it must is named with the key.
TEST(Summarize, unreadable_sweep_is_named)
{
    const ScratchFolder folder;
    expect_refusal(folder, 2, {"is no folder of a sweep"});
    write_sweep(folder, 3, tiny);
    const Json sweep = twiddle::record::read_json(folder.path() / "sweep.json");
    Json twice = sweep;
    twice["runs"].push_back(sweep["runs"][0]);
    Json unnamed = sweep;
    unnamed["runs"][2].erase("model");
    Json newer = sweep;
    newer["format"] = 2;
    Json empty = sweep;
    empty["runs"] = Json::array();
    const std::vector<std::pair<Json, std::string>> cases = {{twice, "'small-sphere/cpg-c/seed-1' twice"},
                                                             {unnamed, "'model' must be a text"},
                                                             {newer, "'format' must be 1"},
                                                             {empty, "'runs' must be a list of runs"}};
    for (const auto &[text, expected] : cases) {
        folder.write("sweep.json", text.dump());
        expect_refusal(folder, 1, {"sweep.json", expected});
    }
}

} // namespace
