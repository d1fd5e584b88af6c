#include "../scratch_folder.hpp"
#include "program.hpp"
#include "record/json_file.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;

// Five runs: two objects, two models, and one variant.
std::string manifest_text(int trials, const std::string &friction = "0.4")
{
    return "trials = " + std::to_string(trials) +
           "\n[[runs]]\nobjects = [\"small-sphere\", \"large-cube\"]\nmodels = [\"cpg-c\", \"cpg-h\"]\nseeds = 1\n"
           "[[runs]]\nobjects = [\"small-sphere\"]\nmodels = [\"cpg-s\"]\ncentre = [false]\nseeds = 1\n"
           "variant = \"slippery\"\nset = { \"contact.friction\" = " +
           friction + " }\n";
}

const std::vector<std::string> folders = {"small-sphere/cpg-c/seed-1", "small-sphere/cpg-h/seed-1",
                                          "large-cube/cpg-c/seed-1", "large-cube/cpg-h/seed-1",
                                          "slippery/small-sphere/cpg-s-no-centre/seed-1"};

Outcome sweep(const fs::path &manifest, const fs::path &out, const std::string &more = "")
{
    return run_twiddle("sweep " + manifest.string() + " --out " + out.string() + " " + more);
}

// The bytes of all files below `folder` by their names; run.json only as far as it does not name the folder itself.
std::map<std::string, std::string> files_below(const fs::path &folder)
{
    std::map<std::string, std::string> files;
    for (const auto &entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::string text = text_of(entry.path());
        if (entry.path().filename() == "run.json") {
            twiddle::record::Json run = twiddle::record::read_json(entry.path());
            run.erase("command");
            text = run.dump();
        }
        files[fs::relative(entry.path(), folder).string()] = text;
    }
    return files;
}

// The files of an uninterrupted sweep with one job.
std::map<std::string, std::string> expected_files(const ScratchFolder &folder, const fs::path &manifest)
{
    const fs::path out = folder.path() / "whole";
    EXPECT_EQ(sweep(manifest, out, "--jobs 1").status, 0);
    return files_below(out);
}

// A sweep in a process group of its own, as a terminal would start it.
class BackgroundSweep
{
  public:
    BackgroundSweep(const fs::path &manifest, fs::path out, const std::string &jobs) : out_(std::move(out))
    {
        process_ = fork();
        if (process_ == 0) {
            setpgid(0, 0);
            const std::string log = out_.string() + ".log";
            if (freopen(log.c_str(), "w", stderr) == nullptr) _exit(127);
            execl(TWIDDLE_PROGRAM, "twiddle", "sweep", manifest.c_str(), "--out", out_.c_str(), "--jobs", jobs.c_str(),
                  nullptr);
            _exit(127);
        }
        setpgid(process_, process_);
    }
    ~BackgroundSweep()
    {
        if (process_ <= 0) return;
        kill(-process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    BackgroundSweep(const BackgroundSweep &) = delete;
    BackgroundSweep &operator=(const BackgroundSweep &) = delete;

    pid_t process() const
    {
        return process_;
    }

    // Wait until something holds; false if it does not within a minute.
    static bool wait_until(const std::function<bool()> &holds)
    {
        for (int i = 0; i < 30'000; ++i) {
            if (holds()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return false;
    }

    // Wait until a run is complete and another one is at work.
    bool wait_until_half_way() const
    {
        return wait_until([&] {
            bool complete = false;
            bool at_work = false;
            for (const std::string &folder : folders) {
                complete = complete || fs::exists(out_ / folder / "trials.csv");
                at_work = at_work || fs::exists(out_ / folder / "trials.csv.part");
            }
            return complete && at_work;
        });
    }

    // Stop the one worker in the middle of its work, so that it cannot end by itself; returns its process.
    pid_t stop_worker() const
    {
        const std::string id = std::to_string(process_);
        pid_t worker = 0;
        const bool stopped = wait_until([&] {
            const std::string children = text_of("/proc/" + id + "/task/" + id + "/children");
            worker = children.empty() ? 0 : static_cast<pid_t>(std::stol(children));
            if (worker == 0 || kill(worker, SIGSTOP) != 0) return false;
            return text_of("/proc/" + std::to_string(worker) + "/stat").find(") T ") != std::string::npos;
        });
        return stopped ? worker : 0;
    }

    // Wait for its end; returns the status as waitpid() gives it.
    int wait()
    {
        int status = 0;
        waitpid(process_, &status, 0);
        process_ = 0;
        return status;
    }

    std::string error() const
    {
        return text_of(out_.string() + ".log");
    }

  private:
    fs::path out_;
    pid_t process_ = 0;
};

// The runs are as `twiddle train` and `twiddle replay` make them, and the number of jobs changes no byte. Expected: their files.
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

// Killed half-way, all processes or the starter alone, and started again at once: the same bytes as without.
TEST(Sweep, killed_sweep_goes_on_to_the_same_bytes)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(200));
    const auto files = expected_files(folder, manifest);
    for (const bool all : {true, false}) {
        const fs::path out = folder.path() / (all ? "all" : "starter");
        BackgroundSweep killed(manifest, out, "2");
        ASSERT_TRUE(killed.wait_until_half_way());
        kill(all ? -killed.process() : killed.process(), SIGKILL);
        EXPECT_TRUE(WIFSIGNALED(killed.wait())) << "the sweep ended by itself";
        const Outcome again = sweep(manifest, out, "--jobs 2");
        EXPECT_EQ(again.status, 0) << again.error;
        EXPECT_EQ(files_below(out), files) << all;
    }
}

// Ctrl-C, for all processes or for the starter alone, ends the sweep after the trials in hand with status 130 and one sentence.
TEST(Sweep, interrupted_sweep_goes_on_to_the_same_bytes)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(200));
    const auto files = expected_files(folder, manifest);
    for (const bool all : {true, false}) {
        const fs::path out = folder.path() / (all ? "all" : "starter");
        BackgroundSweep interrupted(manifest, out, "2");
        ASSERT_TRUE(interrupted.wait_until_half_way());
        kill(all ? -interrupted.process() : interrupted.process(), SIGINT);
        const int status = interrupted.wait();
        EXPECT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 130);
        EXPECT_TRUE(is_one_complaint(interrupted.error())) << interrupted.error();
        EXPECT_NE(interrupted.error().find("complete; the same command goes on"), std::string::npos);
        EXPECT_NE(files_below(out), files);
        EXPECT_EQ(sweep(manifest, out, "--jobs 2").status, 0);
        EXPECT_EQ(files_below(out), files) << all;
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

// A run that is trained but not replayed, as a kill between the two leaves it, gets its replay and keeps the rest to the time of
// every file. Expected: the uninterrupted sweep's files.
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
const std::string wild_manifest = R"(trials = 1
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

// A replay that the simulation cannot finish leaves the run complete: run.json has the fault's sentence, which `twiddle replay` ends
// with, and the trajectory has the steps before it.
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

// What is left to do, for a program that starts the runs itself: all runs, then those that are not complete, then none. The
// folder is the sweep's from then on, and nothing is trained.
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

// A folder of another manifest, of another version, of something else, or with a broken sweep.json is refused and stays as it is.
TEST(Sweep, folder_of_something_else_is_not_touched)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(3));
    const fs::path out = folder.path() / "out";
    ASSERT_EQ(sweep(manifest, out).status, 0);
    const auto files = files_below(out);
    const std::vector<std::pair<fs::path, std::string>> others = {
        {folder.write("trials/mine.toml", manifest_text(4)), "trials is 3 there and 4 here"},
        {folder.write("settings/mine.toml", "setup = \"near\"\n" + manifest_text(3)), "setup is \"mid-a\" there"},
        {folder.write("variants/mine.toml", manifest_text(3, "0.3")), "its variants are others"},
        {folder.write("runs/mine.toml", manifest_text(3) + "[[runs]]\nobjects = [\"small-cube\"]\nmodels = \"all\"\n"
                                                           "seeds = 1\n"),
         "its runs are others"},
        {folder.write("yours.toml", manifest_text(3)), "sweep is \"mine\" there and \"yours\" here"}};
    const auto expect_refusal = [&](const Outcome &outcome, const std::string &expected) {
        EXPECT_EQ(outcome.status, 2) << expected;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find(expected), std::string::npos) << outcome.error;
        EXPECT_NE(outcome.error.find("choose another folder by --out"), std::string::npos) << outcome.error;
    };
    for (const auto &[other, expected] : others) {
        expect_refusal(sweep(other, out), expected);
        expect_refusal(sweep(other, out, "--only 0"), expected);
    }
    EXPECT_EQ(files_below(out), files);

    auto json = twiddle::record::read_json(out / "sweep.json");
    json["version"] = "twiddle 0.0.1 (commit 0)";
    twiddle::record::write_json(out / "sweep.json", json);
    expect_refusal(sweep(manifest, out), "version is \"twiddle 0.0.1 (commit 0)\" there");
    std::ofstream(out / "sweep.json") << "{";
    expect_refusal(sweep(manifest, out), "not valid JSON");
    EXPECT_EQ(text_of(out / "sweep.json"), "{");

    folder.write("others/thesis.tex", "years of work");
    expect_refusal(sweep(manifest, folder.path() / "others"), "no sweep of twiddle");
    EXPECT_EQ(files_below(folder.path() / "others").size(), 1U);
    expect_refusal(sweep(manifest, manifest), "is no folder");
}

// A run that cannot be done leaves the others alone; the first one's folder is named; once the reason is gone, the same command
// completes the sweep.
TEST(Sweep, failed_run_leaves_the_others_alone)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(3));
    const auto files = expected_files(folder, manifest);
    const fs::path out = folder.path() / "out";
    ASSERT_EQ(sweep(manifest, out, "--only 0").status, 0);
    std::ofstream(out / folders[0] / "run.json") << "{";
    folder.write("out/" + folders[3] + "/thesis.tex", "years of work");
    const Outcome outcome = sweep(manifest, out, "--jobs 1");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
    for (const std::string &expected : {"2 of 5 runs failed; the first: " + folders[0] + ": ",
                                        std::string("is not valid JSON"), "remove '" + (out / folders[0]).string()}) {
        EXPECT_NE(outcome.error.find(expected), std::string::npos) << outcome.error;
    }
    EXPECT_EQ(text_of(out / folders[0] / "run.json"), "{");
    EXPECT_EQ(text_of(out / folders[3] / "thesis.tex"), "years of work");
    fs::remove_all(out / folders[0]);
    fs::remove_all(out / folders[3]);
    const Outcome again = sweep(manifest, out);
    EXPECT_EQ(again.status, 0);
    EXPECT_NE(again.output.find("3 were before"), std::string::npos) << again.output;
    EXPECT_EQ(files_below(out), files);
}

// A worker that is killed, as one that crashes would be, counts as a failed run, and the others go on.
TEST(Sweep, killed_worker_is_a_failed_run)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(100));
    const auto files = expected_files(folder, manifest);
    const fs::path out = folder.path() / "out";
    BackgroundSweep background(manifest, out, "1");
    ASSERT_TRUE(BackgroundSweep::wait_until([&] { return fs::exists(out / folders[0] / "trials.csv.part"); }));
    const pid_t worker = background.stop_worker();
    ASSERT_GT(worker, 0);
    kill(worker, SIGKILL);
    const int status = background.wait();
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_NE(background.error().find("1 of 5 runs failed"), std::string::npos) << background.error();
    EXPECT_NE(background.error().find("ended by the signal"), std::string::npos) << background.error();
    EXPECT_EQ(sweep(manifest, out).status, 0);
    EXPECT_EQ(files_below(out), files);
}

// Nothing can be written: one sentence that names the folder, status 1.
TEST(Sweep, unwritable_folder_is_one_sentence)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(3));
    for (const fs::path &out : {manifest / "below", fs::path("/proc/twiddle")}) {
        const Outcome outcome = sweep(manifest, out);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find("cannot make folder '" + out.string()), std::string::npos) << outcome.error;
    }
}

// Wrong use is one sentence with status 2, before anything is written.
TEST(Sweep, wrong_use_is_one_sentence)
{
    const ScratchFolder folder;
    const fs::path out = folder.path() / "out";
    const std::string manifest = folder.write("mine.toml", manifest_text(3)).string();
    const std::string broken = folder.write("broken.toml", "trials = 3\n").string();
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "MANIFEST is required"},
        {broken, "broken.toml:1: runs is missing"},
        {"/nowhere.toml", "/nowhere.toml: there is no such file"},
        {manifest + " --jobs 0", "--jobs 0: expected a whole number from 1"},
        {manifest + " --only 5", "--only 5: expected a whole number from 0 to 4"},
        {manifest + " --only -1", "--only -1"},
        {manifest + " --models /nowhere", "'/nowhere' is no models folder"}};
    for (const auto &[arguments, expected] : cases) {
        const Outcome outcome = run_twiddle("sweep --out " + out.string() + " " + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find(expected), std::string::npos) << outcome.error;
        EXPECT_FALSE(fs::exists(out)) << arguments;
    }
}

} // namespace
