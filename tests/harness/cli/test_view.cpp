// twiddle view: the pages of runs and sweeps, and what they refuse.
#include "../scratch_folder.hpp"
#include "program.hpp"
#include "record/csv_columns.hpp"
#include "record/json_file.hpp"
#include "sweep_fixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace twiddle::test;
using twiddle::record::Json;
namespace fs = std::filesystem;

std::size_t count(const std::string &text, const std::string &part)
{
    std::size_t times = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++times;
    }
    return times;
}

Json data_of(const std::string &page)
{
    const std::string begin = "id=\"data\">";
    const std::size_t at = page.find(begin) + begin.size();
    return Json::parse(page.substr(at, page.find("</script>", at) - at));
}

// `text` with the first `from` as `to`.
std::string changed(std::string text, const std::string &from, const std::string &to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// One run with a replay, trained once, and copies of it to spoil.
class View : public testing::Test
{
  protected:
    static void SetUpTestSuite()
    {
        trained_ = new ScratchFolder;
        const std::string run = (trained_->path() / "run").string();
        ASSERT_EQ(run_twiddle("train --object small-sphere --model cpg-h --trials 20 --out " + run).status, 0);
        ASSERT_EQ(run_twiddle("replay " + run).status, 0);
    }
    static void TearDownTestSuite()
    {
        delete trained_;
        trained_ = nullptr;
    }

    View()
    {
        fs::copy(trained_->path() / "run", run());
    }

    fs::path run() const
    {
        return folder_.path() / "run";
    }
    std::string page() const
    {
        return text_of(run() / "replay.html");
    }
    void change(const std::string &file, const std::string &from, const std::string &to) const
    {
        folder_.write("run/" + file, changed(text_of(run() / file), from, to));
    }
    // Refused in one sentence with `part`, and nothing written.
    void expect_refused(const std::string &arguments, int status, const std::string &part) const
    {
        expect_refusal(run_twiddle("view " + arguments), status, part);
    }
    void expect_refusal(const Outcome &outcome, int status, const std::string &part) const
    {
        EXPECT_EQ(outcome.status, status) << outcome.error;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find(part), std::string::npos) << outcome.error;
        EXPECT_EQ(outcome.output, "");
        for (const auto &entry : fs::recursive_directory_iterator(folder_.path())) {
            EXPECT_EQ(entry.path().string().find(".html"), std::string::npos) << entry.path();
        }
    }

    ScratchFolder folder_;

  private:
    static ScratchFolder *trained_;
};

ScratchFolder *View::trained_ = nullptr;

// Expected: the file's rows, rounded to 0.0001 rad, 1 mN and 0.01 mm, in a page below 100 kB.
TEST_F(View, page_holds_the_trajectory)
{
    const Outcome outcome = run_twiddle("view " + run().string());
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.output, (run() / "replay.html").string() + "\n");
    EXPECT_LT(page().size(), 100000U);
    const Json rows = data_of(page())[0]["rows"];
    const std::vector<std::pair<std::string, double>> columns = {
        {"actual_fei_rad", 1e4}, {"actual_aai_rad", 1e4},  {"actual_fet_rad", 1e4},  {"actual_ot_rad", 1e4},
        {"object_rad", 1e4},     {"index_contact_n", 1e3}, {"thumb_contact_n", 1e3}, {"index_x_m", 1e5},
        {"index_y_m", 1e5},      {"index_z_m", 1e5},       {"thumb_x_m", 1e5},       {"thumb_y_m", 1e5},
        {"thumb_z_m", 1e5}};
    ASSERT_EQ(rows.size(), 300U);
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const auto &[name, parts] = columns[column];
        const auto values = twiddle::record::read_csv_columns(run() / "trajectory.csv", {name}).front();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            EXPECT_NEAR(rows[i][column].get<double>(), values[i] * parts, 0.5 + 1e-9) << name << " " << i;
        }
    }
}

// Expected: the page of a run does not depend on the folder that it was done in, nor on how that was typed.
TEST_F(View, page_is_the_same_wherever_the_run_was_done)
{
    ASSERT_EQ(run_twiddle("view " + run().string()).status, 0);
    const std::string here = page();
    const fs::path elsewhere = folder_.path() / "elsewhere";
    ASSERT_EQ(run_twiddle("train --seed 1 --model cpg-h --object small-sphere --trials 20 --out " + elsewhere.string())
                  .status,
              0);
    ASSERT_EQ(run_twiddle("replay " + elsewhere.string()).status, 0);
    ASSERT_EQ(run_twiddle("view " + elsewhere.string()).status, 0);
    EXPECT_EQ(text_of(elsewhere / "replay.html"), here);
}

TEST_F(View, two_runs_stand_side_by_side_in_a_file_of_choice)
{
    const fs::path file = folder_.path() / "both.html";
    const Outcome outcome =
        run_twiddle("view " + run().string() + " --compare " + run().string() + " --out " + file.string());
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.output, file.string() + "\n");
    EXPECT_EQ(data_of(text_of(file)).size(), 2U);
    EXPECT_FALSE(fs::exists(run() / "replay.html"));
}

// Expected: as many elements as in a page of plain texts, whichever text of the run would end a script; a text that
// stands for something may be refused.
TEST_F(View, no_text_of_a_run_becomes_markup)
{
    ASSERT_EQ(run_twiddle("view " + run().string()).status, 0);
    const std::string plain = page();
    const std::string evil = "</script><script>alert(1)</script>";
    const Json run_json = twiddle::record::read_json(run() / "run.json");
    std::size_t shown = 0;
    const auto expect_text = [&](const std::string &what) {
        fs::remove(run() / "replay.html");
        const Outcome outcome = run_twiddle("view " + run().string());
        if (outcome.status != 0) {
            EXPECT_TRUE(is_one_complaint(outcome.error)) << what << ": " << outcome.error;
            return;
        }
        ++shown;
        EXPECT_EQ(count(page(), "<script"), count(plain, "<script")) << what;
        EXPECT_EQ(count(page(), "</script"), count(plain, "</script")) << what;
    };
    for (const auto &[key, value] : run_json.items()) {
        if (!value.is_string()) continue;
        Json spoiled = run_json;
        spoiled[key] = evil;
        folder_.write("run/run.json", spoiled.dump());
        expect_text(key);
    }
    folder_.write("run/run.json", run_json.dump());
    const std::string trajectory = text_of(run() / "trajectory.csv");
    for (std::size_t at = 0; trajectory[at] == '#'; at = trajectory.find('\n', at) + 1) {
        const std::size_t end = trajectory.find('\n', at);
        const std::size_t colon = std::min(trajectory.find(": ", at), end);
        std::string spoiled = trajectory;
        folder_.write("run/trajectory.csv", spoiled.replace(colon + 2, end - std::min(end, colon + 2), evil));
        expect_text(trajectory.substr(at, end - at));
    }
    EXPECT_GE(shown, 8U);
}

TEST_F(View, run_without_a_trajectory_is_refused)
{
    fs::remove(run() / "trajectory.csv");
    expect_refused(run().string(), 2, "holds no trajectory.csv");
    expect_refused("/nonexistent", 2, "'/nonexistent' is no folder of a run");
}

TEST_F(View, trajectory_of_other_columns_is_refused)
{
    change("trajectory.csv", "actual_fei_rad", "actual_wrist_rad");
    expect_refused(run().string(), 1, "has no column 'actual_fei_rad'");
}

TEST_F(View, trajectory_without_the_held_angles_is_refused)
{
    change("trajectory.csv", "# index_distal_deg: ", "# ");
    expect_refused(run().string(), 1, "has no line '# index_distal_deg: ...'");
}

// Expected: an angle beyond the joint's 90 deg cannot be this hand's, nor can one that moves the fingertip elsewhere.
TEST_F(View, trajectory_of_another_hand_is_refused)
{
    change("trajectory.csv", "# index_distal_deg: ", "# index_distal_deg: 1");
    expect_refused(run().string(), 1, "is of another hand: in step 1 a fingertip is");
    change("trajectory.csv", "# index_distal_deg: ", "# index_distal_deg: 9");
    expect_refused(run().string(), 1, "is of another hand: index_distal_deg is 910.957");
}

TEST_F(View, output_that_cannot_be_written_is_named)
{
    const std::string out = "/nonexistent/folder/page.html";
    expect_refused(run().string() + " --out " + out, 1, out);
    expect_refused(run().string() + " --index-only", 2, "is no folder of a sweep");
}

TEST_F(View, full_disk_leaves_nothing_of_a_page)
{
    constexpr int blocks = 16;
    expect_refusal(run_twiddle_on_full_disk("view " + run().string(), blocks), 1, "replay.html");
}

// A page shows what the folder holds; expected: a training from the start takes the old one away.
TEST_F(View, page_goes_with_the_results_of_an_earlier_start)
{
    ASSERT_EQ(run_twiddle("view " + run().string()).status, 0);
    ASSERT_EQ(run_twiddle("train --object small-sphere --model cpg-h --trials 20 --out " + run().string()).status, 0);
    EXPECT_FALSE(fs::exists(run() / "replay.html"));
}

TEST_F(View, second_run_that_is_none_leaves_nothing)
{
    expect_refused(run().string() + " --compare /nonexistent", 2, "'/nonexistent' is no folder of a run");
}

// Expected: every run of the sweep has a page, to which the index has a link; alone, the index has the links.
TEST(ViewSweep, index_opens_the_replay_of_every_run)
{
    const ScratchFolder folder;
    const fs::path out = folder.path() / "out";
    ASSERT_EQ(sweep(folder.write("mine.toml", manifest_text(2)), out).status, 0);
    const Outcome alone = run_twiddle("view " + out.string() + " --index-only");
    EXPECT_EQ(alone.status, 0) << alone.error;
    EXPECT_EQ(alone.output, (out / "index.html").string() + "\n");
    EXPECT_FALSE(fs::exists(out / folders.front() / "replay.html"));
    const std::string index = text_of(out / "index.html");

    EXPECT_EQ(run_twiddle("view " + out.string()).status, 0);
    EXPECT_EQ(text_of(out / "index.html"), index);
    EXPECT_EQ(count(index, "<a href="), folders.size());
    for (const std::string &run : folders) {
        EXPECT_EQ(count(index, "href=\"./" + run + "/replay.html\""), 1U) << run;
        EXPECT_EQ(data_of(text_of(out / run / "replay.html")).size(), 1U) << run;
    }
    EXPECT_EQ(run_twiddle("view " + out.string() + " --out x.html").status, 2);

    // A run that is not there yet is said, and the others are shown.
    fs::remove_all(out / folders.back());
    EXPECT_EQ(run_twiddle("view " + out.string()).status, 0);
    EXPECT_EQ(count(text_of(out / "index.html"), "<a href="), folders.size() - 1);
    EXPECT_EQ(count(text_of(out / "index.html"), "not complete"), 1U);
}

} // namespace
