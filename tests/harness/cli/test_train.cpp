#include "../scratch_folder.hpp"
#include "program.hpp"
#include "record/json_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sstream>
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

const std::string small_run = "train --object medium-cube --model cpg-h --seed 3 --trials 20 --out ";

Outcome train(const fs::path &out, const std::string &more = "")
{
    return run_twiddle(small_run + out.string() + " " + more);
}

std::vector<std::string> files_in(const fs::path &folder)
{
    std::vector<std::string> names;
    for (const auto &entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
}

// The folder of a complete run made to look as if the program had been killed when `bytes` of trials.csv were written.
void make_interrupted(const fs::path &complete, const fs::path &folder, std::size_t bytes)
{
    fs::create_directories(folder);
    std::ofstream(folder / "trials.csv.part") << text_of(complete / "trials.csv").substr(0, bytes);
    twiddle::record::Json run = twiddle::record::read_json(complete / "run.json");
    run["state"] = "running";
    run.erase("summary");
    twiddle::record::write_json(folder / "run.json", run);
}

// The same seed gives the same bytes, in two folders and twice in one.
TEST(Train, same_run_gives_the_same_bytes)
{
    const ScratchFolder folder;
    const fs::path a = folder.path() / "a";
    const fs::path b = folder.path() / "deep" / "b";
    const Outcome outcome = train(a);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NE(outcome.output.find("mean rotation of the first 20 trials"), std::string::npos) << outcome.output;
    EXPECT_EQ(files_in(a), (std::vector<std::string>{"policy.json", "run.json", "trials.csv"}));
    const std::string trials = text_of(a / "trials.csv");
    EXPECT_EQ(train(b).status, 0);
    EXPECT_EQ(text_of(b / "trials.csv"), trials);
    EXPECT_EQ(text_of(b / "policy.json"), text_of(a / "policy.json"));
    EXPECT_EQ(train(a).status, 0);
    EXPECT_EQ(text_of(a / "trials.csv"), trials);
}

// Off a terminal the progress is ten plain lines on standard error.
TEST(Train, progress_is_plain_lines_off_a_terminal)
{
    const ScratchFolder folder;
    const Outcome outcome = train(folder.path() / "run");
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 10) << outcome.error;
    EXPECT_EQ(outcome.error.find_first_of("\r\033"), std::string::npos);
}

// A run killed at any byte and resumed ends with the bytes of one that was not. Expected: the
// uninterrupted run's files.
TEST(Train, resumed_run_equals_an_uninterrupted_one)
{
    const ScratchFolder folder;
    const fs::path whole = folder.path() / "whole";
    ASSERT_EQ(train(whole).status, 0);
    const std::string trials = text_of(whole / "trials.csv");
    const std::size_t first_row = trials.find("\n1,") + 1;
    const std::size_t row_end = trials.find("\n12,") + 1;
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{30}, first_row, first_row + 5, row_end, row_end + 9,
                                    trials.size() - 1, trials.size()}) {
        const fs::path cut = folder.path() / ("cut-" + std::to_string(bytes));
        make_interrupted(whole, cut, bytes);
        const Outcome outcome = train(cut, "--resume");
        EXPECT_EQ(outcome.status, 0) << bytes << ": " << outcome.error;
        EXPECT_EQ(text_of(cut / "trials.csv"), trials) << bytes;
        EXPECT_EQ(text_of(cut / "policy.json"), text_of(whole / "policy.json")) << bytes;
        EXPECT_EQ(files_in(cut), files_in(whole)) << bytes;
    }
    const Outcome again = train(whole, "--resume");
    EXPECT_EQ(again.status, 0);
    EXPECT_NE(again.output.find("already complete"), std::string::npos) << again.output;
}

// A log whose rows this program would not have made is not continued, and stays as it is.
TEST(Train, changed_log_is_not_continued)
{
    const ScratchFolder folder;
    const fs::path whole = folder.path() / "whole";
    ASSERT_EQ(train(whole).status, 0);
    std::string trials = text_of(whole / "trials.csv");
    for (const char *row : {"\n4,", "\n9,"}) { // one in the middle, and the last of ten
        const fs::path cut = folder.path() / ("cut-" + std::to_string(row[1]));
        make_interrupted(whole, cut, trials.find("\n10,") + 1);
        std::string changed = text_of(cut / "trials.csv.part");
        const std::size_t rotation = changed.find(row) + 3;
        changed.replace(rotation, changed.find(',', rotation) - rotation, "0.125");
        std::ofstream(cut / "trials.csv.part") << changed;
        const Outcome outcome = train(cut, "--resume");
        EXPECT_EQ(outcome.status, 1);
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_EQ(text_of(cut / "trials.csv.part"), changed);
    }
}

// Ctrl-C ends the run after the trial in hand, with status 130, and leaves a log that --resume completes
// to the same bytes.
TEST(Train, interrupted_run_can_be_resumed)
{
    const ScratchFolder folder;
    const std::string out = (folder.path() / "run").string();
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        execl(TWIDDLE_PROGRAM, "twiddle", "train", "--object", "medium-cube", "--model", "cpg-h", "--seed", "3",
              "--trials", "40", "--out", out.c_str(), nullptr);
        _exit(127);
    }
    const auto rows = [&] {
        const std::string text = text_of(out + "/trials.csv.part");
        return std::count(text.begin(), text.end(), '\n');
    };
    int status = 0;
    pid_t ended = 0;
    while (rows() < 12 && ended == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ended = waitpid(child, &status, WNOHANG);
    }
    ASSERT_EQ(ended, 0) << "the run ended by itself";
    kill(child, SIGINT);
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_FALSE(fs::exists(out + "/trials.csv"));

    const std::string same = "train --object medium-cube --model cpg-h --seed 3 --trials 40 --out ";
    EXPECT_EQ(run_twiddle(same + out + " --resume").status, 0);
    EXPECT_EQ(run_twiddle(same + out + "-whole").status, 0);
    EXPECT_EQ(text_of(out + "/trials.csv"), text_of(out + "-whole/trials.csv"));
}

// A folder with another run, with files of others, or with an unreadable run.json is refused and stays as it is.
TEST(Train, folder_of_something_else_is_not_touched)
{
    const ScratchFolder folder;
    const fs::path run = folder.path() / "run";
    ASSERT_EQ(train(run).status, 0);
    const std::string trials = text_of(run / "trials.csv");
    const std::string json = text_of(run / "run.json");
    for (const char *other : {"--seed 4", "--trials 21", "--no-centre", "--set contact.friction=0.4", "--hand full",
                              "--number double", "--setup near", "--object small-cube", "--model cpg-c"}) {
        std::string command = small_run + run.string() + " ";
        const std::string option = std::string(other).substr(0, std::string(other).find(' ') + 1);
        const std::size_t given = command.find(option);
        if (option.size() > 1 && given != std::string::npos)
            command.erase(given, command.find(' ', given + option.size()) - given + 1);
        for (const char *resume : {"", " --resume"}) {
            const Outcome outcome = run_twiddle(command + other + resume);
            EXPECT_EQ(outcome.status, 2) << other;
            EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
            EXPECT_NE(outcome.error.find("holds another run"), std::string::npos) << outcome.error;
        }
    }
    EXPECT_EQ(text_of(run / "trials.csv"), trials);
    EXPECT_EQ(text_of(run / "run.json"), json);

    folder.write("others/thesis.tex", "years of work");
    EXPECT_EQ(train(folder.path() / "others").status, 2);
    EXPECT_EQ(files_in(folder.path() / "others"), std::vector<std::string>{"thesis.tex"});
    folder.write("broken/run.json", "{");
    EXPECT_EQ(train(folder.path() / "broken").status, 2);
    EXPECT_EQ(text_of(folder.path() / "broken" / "run.json"), "{");
    EXPECT_EQ(train(folder.path() / "others" / "thesis.tex").status, 2);
}

// Replay writes 300 rows whose last rotation is the one that rollout gives for the learned parameters, from run.json
// alone: also for a run of another number type, another hold of the hand and overridden settings.
TEST(Train, replay_repeats_the_run_from_its_folder)
{
    const std::vector<std::pair<std::string, std::string>> runs = {
        {"float", ""},
        {"double", "--number double --set contact.friction=0.4"},
        {"fixed", "--number fixed"},
        {"float", "--hand full --stepper reference"}};
    for (const auto &[number, more] : runs) {
        const ScratchFolder folder;
        const fs::path run = folder.path() / "run";
        const std::string skill = "--object medium-cube --model cpg-h " + more;
        ASSERT_EQ(run_twiddle("train " + skill + " --trials 4 --out " + run.string()).status, 0);
        const Outcome outcome = run_twiddle("replay " + run.string());
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        const auto json = twiddle::record::read_json(run / "run.json");
        EXPECT_EQ(json["number"], number);
        EXPECT_TRUE(json["replay"].contains("min_finger_clearance_m"));

        std::string parameters;
        const auto policy = twiddle::record::read_json(run / "policy.json");
        for (const auto &value : policy["parameters"]) {
            parameters += (parameters.empty() ? "" : ",") + value.dump();
        }
        const std::string rotation = run_twiddle("rollout " + skill, parameters + "\n").output;
        EXPECT_EQ(std::stod(rotation), json["replay"]["rotation_rad"].get<double>()) << more;

        std::istringstream trajectory(text_of(run / "trajectory.csv"));
        int rows = 0;
        for (std::string line; std::getline(trajectory, line);) {
            if (line.empty() || line[0] == '#') continue;
            EXPECT_EQ(std::count(line.begin(), line.end(), ','), 23) << line;
            ++rows;
        }
        EXPECT_EQ(rows, 301); // with the header
        EXPECT_TRUE(fs::exists(run / "object_outline.csv"));
    }
}

// --out writes elsewhere and leaves the run's folder as it is; a run without a policy cannot be replayed.
TEST(Train, replay_elsewhere_leaves_the_run_alone)
{
    const ScratchFolder folder;
    const fs::path run = folder.path() / "run";
    ASSERT_EQ(train(run).status, 0);
    const std::string json = text_of(run / "run.json");
    const fs::path out = folder.path() / "elsewhere.csv";
    EXPECT_EQ(run_twiddle("replay " + run.string() + " --out " + out.string()).status, 0);
    EXPECT_EQ(text_of(run / "run.json"), json);
    EXPECT_EQ(files_in(run), (std::vector<std::string>{"policy.json", "run.json", "trials.csv"}));
    EXPECT_TRUE(fs::exists(out));

    fs::remove(run / "policy.json");
    const Outcome outcome = run_twiddle("replay " + run.string());
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.error.find("no policy.json"), std::string::npos) << outcome.error;
}

// --stepper replays in the other physics: the rotation that rollout gives with that stepper, and never in place
// of the run's own.
TEST(Train, replay_with_another_stepper_is_that_steppers_rollout)
{
    const ScratchFolder folder;
    const fs::path run = folder.path() / "run";
    ASSERT_EQ(train(run).status, 0);
    const std::string json = text_of(run / "run.json");
    std::string parameters;
    const auto policy = twiddle::record::read_json(run / "policy.json");
    for (const auto &value : policy["parameters"]) {
        parameters += (parameters.empty() ? "" : ",") + value.dump();
    }
    const fs::path out = folder.path() / "reference.csv";
    for (const std::string stepper : {"reference", "fast"}) {
        const std::string with_stepper = " --stepper " + stepper;
        const Outcome outcome = run_twiddle("replay " + run.string() + with_stepper + " --out " + out.string());
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        std::string rotation =
            run_twiddle("rollout --object medium-cube --model cpg-h" + with_stepper, parameters + "\n").output;
        rotation.pop_back();
        const std::string text = text_of(out);
        EXPECT_NE(text.find("# rotation_rad: " + rotation + "\n"), std::string::npos) << rotation;
        EXPECT_NE(text.find("stepper: " + stepper + "\n"), std::string::npos);
    }

    const std::string reference = "replay " + run.string() + " --stepper reference";
    for (const std::string &more : {std::string(), " --out " + (run / "." / "trajectory.csv").string()}) {
        const Outcome outcome = run_twiddle(reference + more);
        EXPECT_EQ(outcome.status, 2) << more;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find("--out"), std::string::npos) << outcome.error;
    }
    const Outcome outcome = run_twiddle("replay " + run.string() + " --stepper ode --out " + out.string());
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.error.find("unknown value 'ode' for --stepper"), std::string::npos) << outcome.error;
    EXPECT_EQ(files_in(run), (std::vector<std::string>{"policy.json", "run.json", "trials.csv"}));
    EXPECT_EQ(text_of(run / "run.json"), json);
}

} // namespace
