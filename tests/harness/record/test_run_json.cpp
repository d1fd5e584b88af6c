#include "../scratch_folder.hpp"
#include "record/json_file.hpp"
#include "record/run_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>
#include <vector>

namespace
{

using namespace twiddle::record;
using TrainingRun = twiddle::record::Run; // GoogleTest has a Run of its own
using twiddle::test::error_of;
using twiddle::test::is_one_sentence_with;
using twiddle::test::ScratchFolder;

Run some_run()
{
    Run run;
    run.specification.object = "small-sphere";
    run.specification.model = "cpg-h";
    run.specification.centre = false;
    run.specification.seed = std::numeric_limits<std::uint64_t>::max();
    run.specification.trials = 5000;
    run.specification.hand = "welded";
    run.specification.stepper = "reference";
    run.specification.number = "float";
    run.specification.setup = "mid-a";
    run.specification.settings = R"({"contact":{"friction":0.1},"physics":{"substeps":5}})";
    run.command = "twiddle train --out 'a b'";
    return run;
}

// A run that was written and read is the same run. Expected: the run itself.
TEST(RunJson, run_reads_back_as_it_was)
{
    const ScratchFolder folder;
    TrainingRun run = some_run();
    run.complete = true;
    run.summary = TrainingSummary{100, 0.125, 500, 2.5, 3};
    write_run(folder.path() / "run.json", run);
    const TrainingRun back = read_run(folder.path() / "run.json");
    EXPECT_EQ(back.specification, run.specification);
    EXPECT_TRUE(back.complete);
    EXPECT_EQ(back.command, run.command);
    ASSERT_TRUE(back.summary);
    EXPECT_EQ(back.summary->first_trials, 100U);
    EXPECT_EQ(back.summary->mean_rotation_of_first_rad, 0.125);
    EXPECT_EQ(back.summary->last_trials, 500U);
    EXPECT_EQ(back.summary->mean_rotation_of_last_rad, 2.5);
    EXPECT_EQ(back.summary->faults, 3U);
    EXPECT_FALSE(back.replay);
}

// Runs that differ in any one field of the specification are different runs; the command is no part of it.
TEST(RunJson, specification_compares_every_field)
{
    const RunSpecification a = some_run().specification;
    std::vector<RunSpecification> others(10, a);
    others[0].object = "x";
    others[1].model = "x";
    others[2].centre = true;
    others[3].seed = 1;
    others[4].trials = 1;
    others[5].hand = "full";
    others[6].stepper = "x";
    others[7].number = "double";
    others[8].setup = "near";
    others[9].settings = R"({"contact":{"friction":0.2},"physics":{"substeps":5}})";
    for (const RunSpecification &other : others) {
        EXPECT_NE(a, other);
    }
    EXPECT_EQ(a, some_run().specification);
    RunSpecification same = a;
    same.settings = R"({"physics": {"substeps": 5.0}, "contact": {"friction": 0.1}})";
    EXPECT_EQ(a, same);
}

// A missing key, or one of another type, is named with the file and what was expected.
TEST(RunJson, wrong_keys_are_named)
{
    const ScratchFolder folder;
    const auto path = folder.path() / "run.json";
    write_run(path, some_run());
    const Json good = read_json(path);
    const std::vector<std::tuple<std::string, Json, std::string>> cases = {
        {"object", 3, "a text"},         {"centre", 1, "true or false"},      {"seed", -1, "a whole number"},
        {"seed", 1.5, "a whole number"}, {"seed", true, "a whole number"},    {"trials", 4294967296, "a whole number"},
        {"settings", 1, "an object"},    {"state", "half", "\"running\" or"}, {"command", nullptr, "a text"}};
    for (const auto &[key, value, expected] : cases) {
        Json wrong = good;
        wrong[key] = value;
        write_json(path, wrong);
        const std::string error = error_of([&] { read_run(path); });
        EXPECT_TRUE(is_one_sentence_with(error, {path.string(), "'" + key + "'", expected})) << error;
        wrong.erase(key);
        write_json(path, wrong);
        EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_run(path); }), {"'" + key + "'", "missing"}));
    }
}

// Text that is no JSON is named with its line, and so is a file that is not there.
TEST(RunJson, malformed_file_is_named_with_its_line)
{
    const ScratchFolder folder;
    const auto path = folder.write("run.json", "{\n  \"object\": \"x\",\n  broken\n}\n");
    EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_run(path); }), {path.string(), "line 3"}));
    folder.write("run.json", "[1]");
    EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_run(path); }), {path.string(), "one JSON object"}));
    folder.write("run.json", "");
    EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_run(path); }), {path.string(), "JSON"}));
    const auto missing = folder.path() / "no.json";
    EXPECT_TRUE(is_one_sentence_with(error_of([&] { read_run(missing); }), {"cannot read", missing.string()}));
}

} // namespace
