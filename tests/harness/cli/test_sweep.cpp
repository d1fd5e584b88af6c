#include "record/json_file.hpp"
#include "sweep_fixture.hpp"

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;

// The runs are as `twiddle train` and `twiddle replay` make them, and the number of jobs changes no byte.
// Expected: their files.
TEST(Sweep, runs_are_those_of_train_and_replay_with_any_number_of_jobs)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(12));
    const auto files = expected_files(folder, manifest);
    EXPECT_EQ(files.size(), 1 + 5 * folders.size()); // sweep.json; run.json, policy.json and three tables
    const fs::path out = folder.path() / "two";
    EXPECT_EQ(sweep(manifest, out, "--jobs 2").status, 0);
    EXPECT_EQ(files_below(out), files);

    const fs::path trained = folder.path() / "trained";
    ASSERT_EQ(
        run_twiddle("train --object small-sphere --model cpg-s --no-centre --set contact.friction=0.4 --trials 12 "
                    "--seed 1 --out " +
                    trained.string())
            .status,
        0);
    ASSERT_EQ(run_twiddle("replay " + trained.string()).status, 0);
    EXPECT_EQ(files_below(trained).size(), 5U);
    for (const auto &[name, text] : files_below(trained)) {
        EXPECT_EQ(files.at(folders.back() + "/" + name), text) << name;
    }
}

// A complete sweep is left as it is, to the time of every file.
TEST(Sweep, second_start_does_nothing)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(3));
    const fs::path out = folder.path() / "out";
    const Outcome first = sweep(manifest, out);
    EXPECT_EQ(first.status, 0);
    EXPECT_EQ(first.error, "");
    EXPECT_NE(first.output.find("5 of 5 runs are complete"), std::string::npos) << first.output;
    std::map<std::string, fs::file_time_type> times;
    for (const auto &entry : fs::recursive_directory_iterator(out)) {
        times[entry.path()] = fs::last_write_time(entry);
    }
    const Outcome second = sweep(manifest, out);
    EXPECT_EQ(second.status, 0);
    EXPECT_NE(second.output.find("5 were before"), std::string::npos) << second.output;
    for (const auto &entry : fs::recursive_directory_iterator(out)) {
        EXPECT_EQ(times[entry.path()], fs::last_write_time(entry)) << entry.path();
    }
}

// What a kill in the middle of a first write leaves is gone over. Expected: the uninterrupted sweep's
// files and the litter.
TEST(Sweep, half_written_first_files_are_no_obstacle)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(3));
    auto files = expected_files(folder, manifest);
    const fs::path out = folder.path() / "out";
    folder.write("out/sweep.json.12-34.part", "{ \"for");
    files["sweep.json.12-34.part"] = "{ \"for";
    EXPECT_EQ(sweep(manifest, out, "--only 0").status, 0);
    folder.write("out/" + folders[1] + "/run.json.part", "{ \"wh");
    fs::create_directories(out / folders[2]);
    fs::remove(out / folders[0] / "policy.json"); // killed between policy.json and run.json, or removed by somebody
    EXPECT_EQ(sweep(manifest, out).status, 0);
    EXPECT_EQ(files_below(out), files);
}

// --only does one run; tasks that start together make the sweep. Expected: the files of a sweep in one go.
TEST(Sweep, single_runs_started_together_make_the_sweep)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(6));
    const auto files = expected_files(folder, manifest);
    const fs::path out = folder.path() / "out";
    std::vector<std::thread> tasks;
    std::vector<Outcome> outcomes(folders.size());
    for (std::size_t i = 0; i < folders.size(); ++i) {
        tasks.emplace_back([&, i] { outcomes[i] = sweep(manifest, out, "--only " + std::to_string(i)); });
    }
    for (std::thread &task : tasks) {
        task.join();
    }
    for (const Outcome &outcome : outcomes) {
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_NE(outcome.output.find("1 of 1 run is complete"), std::string::npos) << outcome.output;
    }
    EXPECT_EQ(files_below(out), files);

    const fs::path one = folder.path() / "one";
    EXPECT_EQ(sweep(manifest, one, "--only 4").status, 0);
    EXPECT_EQ(files_below(one).size(), 6U);
    EXPECT_TRUE(fs::exists(one / folders[4] / "policy.json"));
}

// A run that is trained but not replayed, as a kill between the two leaves it, gets its replay and keeps the rest to
// the time of every file. Expected: the uninterrupted sweep's files.
TEST(Sweep, missing_replay_is_made_up_for_without_training)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(3));
    const auto files = expected_files(folder, manifest);
    const fs::path out = folder.path() / "whole";
    const fs::path run = out / folders[0];
    fs::remove(run / "trajectory.csv");
    fs::remove(run / "object_outline.csv");
    auto json = twiddle::record::read_json(run / "run.json");
    json.erase("replay");
    twiddle::record::write_json(run / "run.json", json);
    fs::remove(out / folders[1] / "object_outline.csv");
    const auto trained = fs::last_write_time(run / "trials.csv");
    const Outcome outcome = sweep(manifest, out);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NE(outcome.output.find("3 were before"), std::string::npos) << outcome.output;
    EXPECT_EQ(files_below(out), files);
    EXPECT_EQ(fs::last_write_time(run / "trials.csv"), trained);
}

// A set-up far beyond any hand: torques of 10 N m every 10 ms on an object of 1 g.
const std::string wild_manifest = "setup = \"" TWIDDLE_TEST_DATA R"(/setups/mid-a.toml"
trials = 1
stepper = "reference"
[[runs]]
objects = ["small-sphere"]
models = ["cpg-c"]
seeds = 4
variant = "wild"
[runs.set]
"hand.damping_nms_per_rad" = { fei = 1, aai = 1, fet = 1, ot = 1 }
"hand.stiffness_nm_per_rad" = { fei = 10, aai = 10, fet = 10, ot = 10 }
"hand.torque_limit_nm" = 10
"physics.substeps" = 1
"object.mass_kg" = 0.001
"learner.reward_per_rad" = 0.0001
)";

// A replay that the simulation cannot finish leaves the run complete: run.json has the fault's sentence, which
// `twiddle replay` ends with, and the trajectory has the steps before it.
TEST(Sweep, fault_in_a_replay_leaves_the_run_complete)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("wild.toml", wild_manifest);
    const fs::path out = folder.path() / "out";
    const Outcome outcome = sweep(manifest, out);
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    int faults = 0;
    for (const char *seed : {"seed-1", "seed-2", "seed-3", "seed-4"}) {
        const fs::path run = out / "wild" / "small-sphere" / "cpg-c" / seed;
        const twiddle::record::Json replay = twiddle::record::read_json(run / "run.json")["replay"];
        if (!replay.contains("fault")) continue;
        ++faults;
        const auto fault = replay["fault"].get<std::string>();
        const std::string trajectory = text_of(run / "trajectory.csv");
        EXPECT_NE(trajectory.find("# fault: " + fault), std::string::npos) << trajectory.substr(0, 500);
        const std::string last = trajectory.substr(trajectory.rfind('\n', trajectory.size() - 2) + 1);
        EXPECT_NE(fault.find("in step " + std::to_string(std::stoi(last) + 1) + ";"), std::string::npos) << fault;
        const Outcome again = run_twiddle("replay " + run.string());
        EXPECT_EQ(again.status, 1);
        EXPECT_NE(again.error.find(fault), std::string::npos) << again.error;
    }
    EXPECT_GT(faults, 0) << "the set-up is not wild enough";
    const Outcome second = sweep(manifest, out);
    EXPECT_NE(second.output.find("4 were before"), std::string::npos) << second.output;
}

// What is left to do, for a program that starts the runs itself: all runs, then those that are not complete, then none.
// The folder is the sweep's from then on, and nothing is trained.
TEST(Sweep, missing_runs_are_listed)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(3));
    const fs::path out = folder.path() / "out";
    EXPECT_EQ(sweep(manifest, out, "--list-missing").output, "0\n1\n2\n3\n4\n");
    EXPECT_EQ(files_below(out).size(), 1U);
    EXPECT_TRUE(fs::exists(out / "sweep.json"));
    ASSERT_EQ(sweep(manifest, out, "--only 1").status, 0);
    EXPECT_EQ(sweep(manifest, out, "--list-missing").output, "0\n2\n3\n4\n");
    ASSERT_EQ(sweep(manifest, out).status, 0);
    fs::remove(out / folders[3] / "policy.json");
    EXPECT_EQ(sweep(manifest, out, "--list-missing").output, "3\n");
    ASSERT_EQ(sweep(manifest, out).status, 0);
    const Outcome outcome = sweep(manifest, out, "--list-missing");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.output, "");
    const Outcome refused = sweep(folder.write("yours.toml", manifest_text(3)), out, "--list-missing");
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(is_one_complaint(refused.error)) << refused.error;
}

} // namespace
