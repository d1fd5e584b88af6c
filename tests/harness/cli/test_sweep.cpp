#include "record/json_file.hpp"
#include "sweep_fixture.hpp"

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;

// The runs are as `twiddle train` makes them, and the number of jobs changes no byte. Expected: train's files.
TEST(Sweep, runs_are_those_of_train_with_any_number_of_jobs)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(12));
    const auto files = expected_files(folder, manifest);
    EXPECT_EQ(files.size(), 1 + 3 * folders.size()); // sweep.json; run.json, trials.csv and policy.json
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

// What a kill in the middle of a first write leaves is gone over. Expected: the uninterrupted sweep's files and the litter.
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
    EXPECT_EQ(files_below(one).size(), 4U);
    EXPECT_TRUE(fs::exists(one / folders[4] / "policy.json"));
}

} // namespace
