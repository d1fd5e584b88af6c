// Training with the agent on a chip in QEMU, with the images of `make firmware`.
#include "../scratch_folder.hpp"
#include "link/child_process.hpp"
#include "program.hpp"
#include "record/json_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace twiddle::test;
using std::chrono::milliseconds;
using std::chrono::steady_clock;
namespace fs = std::filesystem;

void expect_same_results(const fs::path &a, const fs::path &b)
{
    EXPECT_EQ(text_of(a / "trials.csv"), text_of(b / "trials.csv"));
    EXPECT_EQ(text_of(a / "policy.json"), text_of(b / "policy.json"));
}

class TrainOnEveryBoard : public testing::TestWithParam<std::string>
{
};

// The agent on the emulated chip learns the same, byte for byte, as in the program: every model, with and without
// centre, and other choices of the set-up.
TEST_P(TrainOnEveryBoard, chip_gives_the_bytes_of_the_host)
{
    for (const std::string skill :
         {"--object small-sphere --model cpg-h --seed 1 --trials 25",
          "--object large-cube --model cpg-c --seed 2 --trials 5",
          "--object medium-cylinder --model cpg-m --no-centre --seed 18446744073709551615 --trials 5",
          "--object small-cube --model cpg-s --seed 4 --trials 5",
          "--object medium-sphere --model cpg-h --no-centre --seed 5 --trials 5 --setup " TWIDDLE_TEST_DATA
          "/setups/mid-a.toml --set hand.pd_law=stable "
          "--set 'hand.pd_inertia_kg_m2={ fei = 4e-5, aai = 5e-5, fet = 6e-5, ot = 7e-5 }' "
          "--set oscillators.saturation=each --set oscillators.return_lag=equal --set oscillators.centre_start=target "
          "--set oscillators.phase_start=zero --set learner.selector_noise=none --set "
          "learner.learned_value=unclipped"}) {
        const ScratchFolder folder;
        const fs::path host = folder.path() / "host";
        const fs::path chip = folder.path() / "chip";
        const Outcome there = run_twiddle("train --target " + GetParam() + " " + skill + " --out " + chip.string());
        ASSERT_EQ(there.status, 0) << there.error;
        const Outcome here = run_twiddle("train --number fixed " + skill + " --out " + host.string());
        ASSERT_EQ(here.status, 0) << here.error;
        expect_same_results(host, chip);
        EXPECT_EQ(twiddle::record::read_json(chip / "run.json")["target"], GetParam());
    }
}

INSTANTIATE_TEST_SUITE_P(Boards, TrainOnEveryBoard, testing::Values("microbit", "mps2-an386", "virt"),
                         [](const auto &board) {
                             std::string name = board.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// The image for a micro:bit's serial line, in a QEMU whose line is a pseudo-terminal, learns the same, too. One trial,
// since QEMU's line carries some hundred round trips a second.
TEST(TrainInEmulator, serial_line_gives_the_bytes_of_the_host)
{
    const ScratchFolder folder;
    const fs::path output = folder.path() / "output";
    twiddle::link::ChildProcess qemu({"qemu-system-arm", "-M", "microbit", "-display", "none", "-monitor", "none",
                                      "-serial", "pty", "-kernel",
                                      TWIDDLE_FIRMWARE "/microbit-O2/bin/agent_serial_fixed"},
                                     folder.path(), output);
    std::string port;
    while (port.empty() && qemu.end().empty()) { // "char device redirected to /dev/pts/3 (label serial0)"
        std::istringstream words(text_of(output));
        while (words >> port && port.rfind("/dev/", 0) != 0) {
            port.clear();
        }
    }
    const std::string skill = " --object small-sphere --model cpg-h --seed 6 --trials 1 --out ";
    const Outcome there = run_twiddle("train --port " + port + skill + (folder.path() / "chip").string());
    ASSERT_EQ(there.status, 0) << there.error << qemu.end() << text_of(output);
    ASSERT_EQ(run_twiddle("train --number fixed" + skill + (folder.path() / "host").string()).status, 0);
    expect_same_results(folder.path() / "host", folder.path() / "chip");
}

const std::string interrupted_skill = "--object medium-cube --model cpg-h --seed 3 --trials 40";

// A program that trains on the emulated microbit, and what happens to it.
class Program
{
  public:
    explicit Program(fs::path out) : out_(std::move(out)), error_(out_.string() + ".error")
    {
        process_ = ::fork();
        if (process_ == 0) {
            ::setpgid(0, 0);
            const int error = ::open(error_.c_str(), O_WRONLY | O_CREAT, 0600);
            ::dup2(error, STDERR_FILENO);
            const std::string command = std::string("exec ") + TWIDDLE_PROGRAM + " train --target microbit " +
                                        interrupted_skill + " --out " + out_.string();
            ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            ::_exit(127);
        }
        ::setpgid(process_, process_); // whoever of the two comes first
    }

    // Wait until so many trials are logged; false if the program ends before.
    bool reaches(int trials)
    {
        while (::waitpid(process_, &status_, WNOHANG) == 0) {
            const std::string log = text_of(out_ / "trials.csv.part");
            if (log.find("\n" + std::to_string(trials) + ",") != std::string::npos) return true;
            std::this_thread::sleep_for(milliseconds(2));
        }
        return false;
    }

    // The process group of the program, as a terminal signals it.
    void signal_group(int signal) const
    {
        ::kill(-process_, signal);
    }

    // The program's QEMU.
    pid_t qemu() const
    {
        const std::string process = std::to_string(process_);
        std::ifstream children("/proc/" + process + "/task/" + process + "/children");
        pid_t child = 0;
        children >> child;
        return child;
    }

    // Wait for the program's end; returns its exit status.
    int end()
    {
        ::waitpid(process_, &status_, 0);
        return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
    }

    // The last line of standard error.
    std::string complaint() const
    {
        const std::string text = text_of(error_);
        return text.substr(text.rfind('\n', text.size() - 2) + 1);
    }

  private:
    fs::path out_;
    fs::path error_;
    pid_t process_ = 0;
    int status_ = 0;
};

void expect_resumable(const fs::path &run)
{
    const ScratchFolder folder;
    const fs::path whole = folder.path() / "whole";
    const std::string resume = "train --resume --target microbit " + interrupted_skill + " --out " + run.string();
    const Outcome outcome = run_twiddle(resume);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    ASSERT_EQ(run_twiddle("train --number fixed " + interrupted_skill + " --out " + whole.string()).status, 0);
    expect_same_results(whole, run);
}

// A QEMU that is killed, and one that stands still, end the run within 5 s in one sentence; the run can be resumed.
TEST(TrainInEmulator, lost_emulator_ends_within_5_s)
{
    for (const auto &[signal, sentence] :
         {std::pair{SIGKILL, "the emulated microbit has gone: its QEMU was ended by the signal Killed; "},
          std::pair{SIGSTOP, "the emulated microbit has not answered for 3 s; "}}) {
        const ScratchFolder folder;
        const fs::path out = folder.path() / "run";
        Program run(out);
        ASSERT_TRUE(run.reaches(5));
        const pid_t qemu = run.qemu();
        ASSERT_GT(qemu, 0);
        ASSERT_EQ(::kill(qemu, signal), 0);
        const auto start = steady_clock::now();
        EXPECT_EQ(run.end(), 1);
        EXPECT_LT(steady_clock::now() - start, milliseconds(5000)) << sentence;
        EXPECT_TRUE(is_one_complaint(run.complaint())) << run.complaint();
        EXPECT_NE(run.complaint().find(sentence), std::string::npos) << run.complaint();
        EXPECT_NE(::kill(qemu, 0), 0) << "QEMU outlived the run";
        expect_resumable(out);
    }
}

// Ctrl-C at the terminal ends the run after the trial in hand, and its QEMU with it.
TEST(TrainInEmulator, interrupted_run_can_be_resumed)
{
    const ScratchFolder folder;
    const fs::path out = folder.path() / "run";
    Program run(out);
    ASSERT_TRUE(run.reaches(5));
    const pid_t qemu = run.qemu();
    run.signal_group(SIGINT);
    EXPECT_EQ(run.end(), 130);
    EXPECT_NE(run.complaint().find("--resume goes on"), std::string::npos) << run.complaint();
    EXPECT_NE(::kill(qemu, 0), 0) << "QEMU outlived the run";
    expect_resumable(out);
}

// A program that is killed leaves no QEMU behind.
TEST(TrainInEmulator, qemu_ends_with_a_killed_program)
{
    const ScratchFolder folder;
    Program run(folder.path() / "run");
    ASSERT_TRUE(run.reaches(3));
    const pid_t qemu = run.qemu();
    run.signal_group(SIGKILL);
    run.end();
    const auto end = steady_clock::now() + std::chrono::seconds(5);
    const auto is_there = [&] { // an orphan may remain in the table of processes, dead
        std::ifstream stat("/proc/" + std::to_string(qemu) + "/stat");
        const std::string text{std::istreambuf_iterator<char>(stat), std::istreambuf_iterator<char>()};
        return !text.empty() && text.find(") Z ") == std::string::npos;
    };
    while (is_there() && steady_clock::now() < end) {
        std::this_thread::sleep_for(milliseconds(5));
    }
    EXPECT_FALSE(is_there());
}

} // namespace
