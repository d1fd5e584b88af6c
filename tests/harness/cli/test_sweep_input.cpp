// What a sweep refuses, and what it does where it cannot write.
#include "record/json_file.hpp"
#include "sweep_fixture.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace twiddle::test;
namespace fs = std::filesystem;

// A folder of another manifest, of another version, of something else, or with a broken sweep.json is refused
// and stays as it is.
TEST(Sweep, folder_of_something_else_is_not_touched)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", manifest_text(3));
    const fs::path out = folder.path() / "out";
    ASSERT_EQ(sweep(manifest, out).status, 0);
    const auto files = files_below(out);
    const std::vector<std::pair<fs::path, std::string>> others = {
        {folder.write("trials/mine.toml", manifest_text(4)), "trials is 3 there and 4 here"},
        {folder.write("settings/mine.toml", "setup = \"near\"\n" + manifest_text(3)), "there and \"near\" here"},
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

// --setup takes the place of the manifest's set-up: sweep.json and run.json hold it, the command in run.json names it,
// and a folder of another one is refused. Expected: the settings of a manifest that names the set-up itself.
TEST(Sweep, set_up_can_be_chosen_for_the_whole_sweep)
{
    const ScratchFolder folder;
    const fs::path manifest = folder.write("mine.toml", "setup = \"mid-b\"\n" + manifest_text(3));
    const fs::path near = folder.write("near/mine.toml", "setup = \"near\"\n" + manifest_text(3));
    const fs::path out = folder.path() / "out";
    ASSERT_EQ(sweep(manifest, out, "--setup near").status, 0);
    EXPECT_EQ(files_below(out), expected_files(folder, near));
    const auto run = twiddle::record::read_json(out / folders[0] / "run.json");
    EXPECT_EQ(run["setup"], "near");
    EXPECT_NE(run["command"].get<std::string>().find("--setup near"), std::string::npos) << run["command"];

    const Outcome refused = sweep(manifest, out);
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(is_one_complaint(refused.error)) << refused.error;
    EXPECT_NE(refused.error.find("setup is \"near\" there and \"mid-b\" here"), std::string::npos) << refused.error;
    EXPECT_EQ(sweep(manifest, out, "--setup near").status, 0);
}

// A run that cannot be done leaves the others alone; the first one's folder is named; once the reason is gone, the same
// command completes the sweep.
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
    const std::string object = "trials = 3\n[[runs]]\nobjects = [\"small-ball\"]\nmodels = \"all\"\nseeds = 1\n";
    const std::string unknown = folder.write("unknown.toml", object).string();
    const std::string twice = folder.write("twice.toml", manifest_text(3) + manifest_text(3).substr(11)).string();
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "MANIFEST is required"},
        {broken, "broken.toml:1: runs is missing"},
        {unknown, "unknown.toml:3: objects holds \"small-ball\"; expected \"all\", or a list of some of small-sphere"},
        {twice, "twice.toml:13: run small-sphere/cpg-c/seed-1 is listed twice"},
        {"/nowhere.toml", "/nowhere.toml: there is no such file"},
        {manifest + " --setup nowhere", "unknown set-up 'nowhere'; the set-ups are "},
        {manifest + " --setup /nowhere/mine.toml", "/nowhere/mine.toml"},
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
