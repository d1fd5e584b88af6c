// A sweep that is stopped goes on to the bytes of one that is not.
#include "sweep_fixture.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>
#include <utility>

#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;

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

// Ctrl-C, for all processes or for the starter alone, ends the sweep after the trials in hand with status 130
// and one sentence.
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

// A disk that is full: one sentence that names the file and the reason, status 1; when there is room again, the same
// command gives the same bytes. 4 blocks hold a part of sweep.json, 16 of each log of 200 trials, 8 all but a part of
// the larger models' policy.json.
TEST(Sweep, full_disk_is_one_sentence_and_the_sweep_goes_on)
{
    struct Case {
        int trials, blocks;
        std::string file; // the first that has no room
    };
    const std::string run = folders[0] + "/";
    for (const Case &full : {Case{20, 4, "sweep.json."}, Case{200, 16, run + "trials.csv.part': File too large"},
                             Case{20, 8, run + "policy.json.part': File too large"}}) {
        const ScratchFolder folder;
        const fs::path manifest = folder.write("mine.toml", manifest_text(full.trials));
        const auto files = expected_files(folder, manifest);
        const fs::path out = folder.path() / "out";
        const std::string arguments = "sweep " + manifest.string() + " --out " + out.string() + " --jobs 1";
        const Outcome outcome = run_twiddle_on_full_disk(arguments, full.blocks);
        EXPECT_EQ(outcome.status, 1) << full.file;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find("cannot write '" + (out / full.file).string()), std::string::npos)
            << outcome.error;
        EXPECT_NE(outcome.error.find("File too large"), std::string::npos) << outcome.error;
        const Outcome again = sweep(manifest, out, "--jobs 2");
        EXPECT_EQ(again.status, 0) << again.error;
        for (const auto &entry : fs::directory_iterator(out)) { // what could be written of sweep.json
            if (entry.path().extension() == ".part") fs::remove(entry.path());
        }
        EXPECT_EQ(files_below(out), files) << full.file;
    }
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

} // namespace
