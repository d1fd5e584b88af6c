// Training with the agent on a chip at a port, where a stand-in of this machine is the chip; QEMU is the chip in
// test_train_in_emulator.cpp.
#include "../scratch_folder.hpp"
#include "link/child_process.hpp"
#include "program.hpp"
#include "record/json_file.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;

const std::string skill = "--object medium-cube --model cpg-h --seed 3 --trials 8 --out ";

// Answers before the first trial: greeting, controller, four joints, two fingers, learner, begin.
constexpr long answers_before_trials = 10;
// Of one trial: its start, 300 steps of the set-up's five substeps, its end.
constexpr long answers_of_a_trial = 1 + 300 * 5 + 1;

// A chip at a port, for as long as it lives.
class Chip
{
  public:
    explicit Chip(const std::string &fault = "", long answers = 0)
        : process_(command(fault, answers), folder_.path(), folder_.path() / "output")
    {
        while (!fs::exists(port()) && process_.end().empty()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

    std::string port() const
    {
        return (folder_.path() / "port").string();
    }

    // Time since the fault came, which it did.
    std::chrono::duration<double> since_fault() const
    {
        return fs::file_time_type::clock::now() - fs::last_write_time(port() + ".fault");
    }

  private:
    std::vector<std::string> command(const std::string &fault, long answers) const
    {
        std::vector<std::string> command = {TWIDDLE_CHIP_STAND_IN, port()};
        if (!fault.empty()) command.insert(command.end(), {fault, std::to_string(answers)});
        return command;
    }

    ScratchFolder folder_;
    twiddle::link::ChildProcess process_;
};

std::string last_line(const std::string &text)
{
    const std::size_t end = text.find_last_not_of('\n');
    return end == std::string::npos ? "" : text.substr(text.rfind('\n', end) + 1);
}

void expect_same_results(const fs::path &a, const fs::path &b)
{
    EXPECT_EQ(text_of(a / "trials.csv"), text_of(b / "trials.csv"));
    EXPECT_EQ(text_of(a / "policy.json"), text_of(b / "policy.json"));
}

// A chip at a port learns the same, byte for byte, as the program alone, which is what run.json says.
TEST(TrainOnChip, port_gives_the_bytes_of_the_host)
{
    const ScratchFolder folder;
    const fs::path host = folder.path() / "host";
    const fs::path chips = folder.path() / "chip";
    ASSERT_EQ(run_twiddle("train --number fixed " + skill + host.string()).status, 0);
    const Chip chip;
    const Outcome outcome = run_twiddle("train --port " + chip.port() + " " + skill + chips.string());
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    expect_same_results(host, chips);
    const auto json = twiddle::record::read_json(chips / "run.json");
    EXPECT_EQ(json["target"], "port");
    EXPECT_EQ(json["port"], chip.port());
    EXPECT_EQ(json["number"], "fixed");
    EXPECT_EQ(twiddle::record::read_json(host / "run.json")["target"], "host");
    EXPECT_FALSE(twiddle::record::read_json(host / "run.json").contains("port"));

    ASSERT_EQ(run_twiddle("replay " + chips.string()).status, 0);
    const auto replayed = twiddle::record::read_json(chips / "run.json");
    EXPECT_EQ(replayed["target"], "port");
    EXPECT_EQ(replayed["port"], chip.port());
}

// A chip that falls silent, sends damage or dies ends the run within 5 s in one sentence, wherever that happens: in a
// trial, between two, and while the policy is read. Another chip, or the host, goes on to the same bytes.
TEST(TrainOnChip, faults_end_within_5_s_and_can_be_resumed)
{
    const ScratchFolder folder;
    const fs::path whole = folder.path() / "whole";
    ASSERT_EQ(run_twiddle("train --number fixed " + skill + whole.string()).status, 0);
    const std::vector<long> times = {answers_before_trials + 2 * answers_of_a_trial + 700,
                                     answers_before_trials + 3 * answers_of_a_trial,
                                     answers_before_trials + 8 * answers_of_a_trial + 5};
    const std::vector<std::pair<std::string, std::string>> faults = {
        {"silent", "has not answered for 3 s"}, {"damage", "sent a damaged frame"}, {"die", "has gone: "}};
    for (const auto &[fault, sentence] : faults) {
        for (const long answers : times) {
            const std::string what = fault + " after " + std::to_string(answers);
            const fs::path run = folder.path() / (fault + "-" + std::to_string(answers));
            const Chip bad(fault, answers);
            const Outcome outcome = run_twiddle("train --port " + bad.port() + " " + skill + run.string());
            EXPECT_LT(bad.since_fault().count(), 5) << what;
            EXPECT_EQ(outcome.status, 1) << what;
            const std::string complaint = last_line(outcome.error);
            EXPECT_TRUE(is_one_complaint(complaint)) << what << ": " << outcome.error;
            EXPECT_NE(complaint.find("the chip at '" + bad.port() + "' " + sentence), std::string::npos) << complaint;
            EXPECT_NE(complaint.find("--resume goes on"), std::string::npos) << complaint;
            EXPECT_FALSE(fs::exists(run / "trials.csv")) << what;

            const Chip good;
            const std::string where = fault == "die" ? "--number fixed " : "--port " + good.port() + " ";
            const Outcome resumed = run_twiddle("train --resume " + where + skill + run.string());
            EXPECT_EQ(resumed.status, 0) << what << ": " << resumed.error;
            expect_same_results(whole, run);
        }
    }
}

// A chip that is not well before the first trial leaves no trace: silent, damaging, dead.
TEST(TrainOnChip, chip_that_does_not_start_leaves_no_folder)
{
    const ScratchFolder folder;
    const std::string out = (folder.path() / "run").string();
    for (const auto &[fault, answers] :
         std::vector<std::pair<std::string, long>>{{"silent", 0}, {"damage", 3}, {"die", 1}}) {
        const Chip chip(fault, answers);
        const Outcome outcome = run_twiddle("train --port " + chip.port() + " " + skill + out);
        EXPECT_LT(chip.since_fault().count(), 5) << fault;
        EXPECT_EQ(outcome.status, 1) << fault;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find("the chip at '" + chip.port() + "' "), std::string::npos) << outcome.error;
        EXPECT_FALSE(fs::exists(out)) << fault;
    }
}

// Another number type than the chips', a speed that no port has, two places at once, and no port at all are refused.
TEST(TrainOnChip, wrong_use_is_refused)
{
    const ScratchFolder folder;
    const std::string out = (folder.path() / "run").string();
    const std::vector<std::tuple<std::string, int, std::string>> cases = {
        {"--target microbit --number double", 2, "chips compute in fixed point; leave out --number double"},
        {"--target virt --number float", 2, "chips compute in fixed point; leave out --number float"},
        {"--port /dev/null --number float", 2, "chips compute in fixed point; leave out --number float"},
        {"--target arduino", 2, "expected one of host, microbit, mps2-an386, virt"},
        {"--target microbit --port /dev/null", 2, "--target excludes --port"},
        {"--port /dev/null --baud 12345", 2, "--baud 12345: expected one of 9600, 19200"},
        {"--port /dev/null", 1, "'/dev/null' is no serial port"},
        {"--port /nonexistent/port", 1, "cannot open the port '/nonexistent/port'"}};
    for (const auto &[options, status, expected] : cases) {
        const Outcome outcome = run_twiddle("train " + options + " " + skill + out);
        EXPECT_EQ(outcome.status, status) << options;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find(expected), std::string::npos) << outcome.error;
        EXPECT_FALSE(fs::exists(out)) << options;
    }
    const Outcome rollout = run_twiddle("rollout --object medium-cube --model cpg-h --target microbit");
    EXPECT_EQ(rollout.status, 2);
    EXPECT_NE(rollout.error.find("rollout computes on the host"), std::string::npos) << rollout.error;
}

// Without firmware beside the program's build, the sentence says how to build it.
TEST(TrainOnChip, missing_firmware_is_told)
{
    const ScratchFolder folder;
    const fs::path bin = folder.path() / "build" / "host" / "bin";
    fs::create_directories(bin);
    fs::copy_file(TWIDDLE_PROGRAM, bin / "twiddle");
    const std::string out = (folder.path() / "run").string();
    const std::string error = (folder.path() / "error").string();
    const std::string command = (bin / "twiddle").string() + " train --target microbit " + skill + out + " 2>" + error;
    EXPECT_NE(std::system(command.c_str()), 0);
    const std::string image = (folder.path() / "build/firmware/microbit-O2/bin/agent_fixed").string();
    EXPECT_EQ(text_of(error), "twiddle: there is no firmware '" + image + "'; make firmware builds it\n");
    EXPECT_FALSE(fs::exists(out));
}

} // namespace
