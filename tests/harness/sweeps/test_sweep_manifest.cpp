#include "sweeps/sweep_manifest.hpp"

#include "../scratch_folder.hpp"
#include "experiment/training.hpp"
#include "record/json_file.hpp"
#include "setups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace twiddle::sweeps;
using namespace twiddle::test;
using twiddle::record::Json;
using twiddle::record::RunSpecification;

const SweepFolders here = {TWIDDLE_MODELS, TWIDDLE_SETUPS};

RunSpecification some_defaults()
{
    RunSpecification defaults;
    defaults.setup = "mid-b";
    defaults.stepper = "reference";
    defaults.hand = "welded";
    defaults.number = "float";
    return defaults;
}

SweepPlan plan_of(const std::string &name)
{
    return read_sweep_manifest(here.setups.parent_path() / "sweeps" / (name + ".toml"), here, some_defaults());
}

SweepPlan plan_of_text(const ScratchFolder &folder, const std::string &text)
{
    return read_sweep_manifest(folder.write("mine.toml", text), here, some_defaults());
}

std::set<std::string> folders_of(const SweepPlan &plan)
{
    std::set<std::string> folders;
    for (const PlannedRun &run : plan.runs) {
        folders.insert(run.folder);
    }
    return folders;
}

const std::string one_block = "trials = 10\n[[runs]]\nobjects = [\"small-cube\"]\nmodels = [\"cpg-c\"]\nseeds = 1\n";

// Expected: the counts, by multiplication: 9 objects x (4 models + CPG-H without centre) x 4 seeds; 9 x 4 x 2 x 20;
// 2 objects x (2 models + CPG-H without centre) x 2 seeds; 3 objects x 2 models x 5 seeds x (1 + 11 and 1 + 9
// variants). None forces a set-up.
TEST(SweepManifest, files_of_the_repository_have_their_counts)
{
    const std::vector<std::tuple<std::string, std::size_t, std::uint32_t>> expected = {{"paper", 180, 5000},
                                                                                       {"full", 1440, 5000},
                                                                                       {"smoke", 12, 300},
                                                                                       {"choices", 360, 5000},
                                                                                       {"choices-more", 300, 5000}};
    for (const auto &[name, runs, trials] : expected) {
        const SweepPlan plan = plan_of(name);
        EXPECT_EQ(plan.name, name);
        EXPECT_EQ(plan.runs.size(), runs) << name;
        EXPECT_EQ(folders_of(plan).size(), runs) << name;
        EXPECT_EQ(plan.common.trials, trials) << name;
        EXPECT_EQ(plan.common.setup, some_defaults().setup) << name;
    }
    const std::set<std::string> folders = folders_of(plan_of("paper"));
    EXPECT_EQ(folders.count("small-sphere/cpg-h/seed-1"), 1U);
    EXPECT_EQ(folders.count("large-cube/cpg-h-no-centre/seed-4"), 1U);
    EXPECT_EQ(folders.count("large-cube/cpg-c-no-centre/seed-4"), 0U);
}

// Expected: the combinations in order, by hand.
TEST(SweepManifest, a_block_is_every_combination_of_its_lists)
{
    const ScratchFolder folder;
    const SweepPlan plan =
        plan_of_text(folder, "trials = 10\n[[runs]]\nobjects = [\"small-cube\", \"large-cube\"]\nmodels = [\"cpg-c\"]\n"
                             "centre = [false, true]\nseeds = 2\nvariant = \"a-1.5\"\n");
    std::vector<std::string> found;
    for (const PlannedRun &run : plan.runs) {
        found.push_back(run.folder);
        EXPECT_EQ(run.variant, "a-1.5");
    }
    EXPECT_EQ(found, (std::vector<std::string>{
                         "a-1.5/small-cube/cpg-c-no-centre/seed-1", "a-1.5/small-cube/cpg-c-no-centre/seed-2",
                         "a-1.5/small-cube/cpg-c/seed-1", "a-1.5/small-cube/cpg-c/seed-2",
                         "a-1.5/large-cube/cpg-c-no-centre/seed-1", "a-1.5/large-cube/cpg-c-no-centre/seed-2",
                         "a-1.5/large-cube/cpg-c/seed-1", "a-1.5/large-cube/cpg-c/seed-2"}));
    const RunSpecification &last = plan.runs.back().specification;
    EXPECT_EQ(std::tie(last.object, last.model, last.centre), std::make_tuple("large-cube", "cpg-c", true));
    EXPECT_EQ(last.seed, 2U);
    EXPECT_EQ(last.trials, 10U);
}

// Where the manifest is silent, the program's defaults hold. Expected: the settings as load_setup() gives them, with
// and without the same override.
TEST(SweepManifest, settings_are_those_of_the_set_up_and_the_variant)
{
    const ScratchFolder folder;
    const SweepPlan silent = plan_of_text(folder, one_block);
    const RunSpecification &plain = silent.runs.at(0).specification;
    EXPECT_EQ(plain.setup, "mid-b");
    EXPECT_EQ(plain.stepper, "reference");
    EXPECT_EQ(plain.settings, twiddle::test::load_setup("mid-b").settings);

    const SweepPlan told = plan_of_text(
        folder, "setup = \"near\"\nstepper = \"fast\"\n" + one_block +
                    "[[runs]]\nobjects = [\"small-cube\"]\nmodels = \"all\"\nseeds = 1\nvariant = \"soft\"\n"
                    "set = { \"contact.friction\" = 0.25, \"oscillators.phase_start\" = \"zero\" }\n");
    ASSERT_EQ(told.runs.size(), 5U);
    EXPECT_EQ(told.runs[0].specification.stepper, "fast");
    EXPECT_EQ(told.runs[0].specification.settings, twiddle::test::load_setup("near").settings);
    const auto changed =
        twiddle::test::load_setup("near", {{"contact.friction", "0.25"}, {"oscillators.phase_start", "zero"}});
    EXPECT_EQ(told.runs[4].specification.settings, changed.settings);
}

// A set-up that is chosen for the whole sweep takes the place of the manifest's, and the variants are set over it.
TEST(SweepManifest, chosen_set_up_takes_the_manifests_place)
{
    const ScratchFolder folder;
    const auto path = folder.write("mine.toml", "setup = \"" + mid_a_file() + "\"\n" + one_block +
                                                    "[[runs]]\nobjects = [\"small-cube\"]\nmodels = [\"cpg-c\"]\n"
                                                    "seeds = 1\nvariant = \"soft\"\n"
                                                    "set = { \"contact.friction\" = 0.25 }\n");
    const SweepPlan plan = read_sweep_manifest(path, here, some_defaults(), "near");
    EXPECT_EQ(plan.common.setup, "near");
    EXPECT_EQ(plan.runs.at(0).specification.settings, twiddle::test::load_setup("near").settings);
    EXPECT_EQ(plan.runs.at(1).specification.settings,
              twiddle::test::load_setup("near", {{"contact.friction", "0.25"}}).settings);
    const std::string error = error_of([&] { read_sweep_manifest(path, here, some_defaults(), "nowhere"); });
    EXPECT_TRUE(is_one_sentence_with(error, {"there is no set-up \"nowhere\"", "near"})) << error;
}

// A set-up of one's own lies beside the manifest, wherever the program is started.
TEST(SweepManifest, set_up_file_is_found_beside_the_manifest)
{
    const ScratchFolder folder;
    folder.write("slippery.toml", "[contact]\nfriction = 0.125\n");
    const SweepPlan plan = plan_of_text(folder, "setup = \"slippery.toml\"\n" + one_block);
    EXPECT_EQ(plan.common.setup, "slippery");
    EXPECT_EQ(Json::parse(plan.common.settings)["contact"]["friction"], 0.125);
}

// A run of the plan can be trained.
TEST(SweepManifest, planned_run_can_be_trained)
{
    const ScratchFolder folder;
    RunSpecification run = plan_of("smoke").runs.at(0).specification;
    run.number = "float";
    twiddle::experiment::Training training(run, TWIDDLE_MODELS);
    EXPECT_EQ(training.run_trial().trial, 1U);
}

// Whatever is wrong is said in one sentence with file, line and expectation.
TEST(SweepManifest, mistakes_are_named_with_file_and_line)
{
    const std::string runs = "trials = 10\n[[runs]]\n";
    const std::string object = "objects = [\"small-cube\"]\n";
    const std::string model = "models = [\"cpg-c\"]\n";
    const std::string block = "[[runs]]\n" + object + model + "seeds = 1\n";
    const std::vector<std::tuple<std::string, std::string, std::string>> cases = {
        {block, ":1: ", "trials is missing; expected a whole number from 1"},
        {"trials = 0\n" + block, ":1: ", "trials is 0; expected a whole number from 1"},
        {"trials = 2.5\n" + block, ":1: ", "trials is 2.5"},
        {"trials = 10000001\n" + block, ":1: ", "to 10000000"},
        {"trials = 10\n", ":1: ", "runs is missing; expected one block [[runs]]"},
        {"trials = 10\nruns = 3\n", ":2: ", "runs is 3"},
        {"trials = 10\nruns = [3]\n", ":2: ", "expected one block [[runs]]"},
        {"trials = 10\n[runs]\n", ":2: ", "expected one block [[runs]]"},
        {"trials = 10\ntrails = 10\n" + block, ":2: ", "no key \"trails\" here; expected one of trials, setup"},
        {runs + object + model + "seed = 1\n", ":5: ", "no key \"seed\" here; expected one of objects, models"},
        {"setup = \"nowhere\"\n" + one_block, ":1: ", "nowhere\" in"},
        {"setup = 3\n" + one_block, ":1: ", "setup is 3; expected the name of a set-up"},
        {"stepper = \"slow\"\n" + one_block, ":1: ", "stepper is \"slow\"; expected one of reference, fast"},
        {runs + "objects = [\"small-ball\"]\n" + model + "seeds = 1\n",
         ":3: ", "objects holds \"small-ball\"; expected \"all\", or a list of some of small-sphere"},
        {runs + "objects = []\n" + model + "seeds = 1\n", ":3: ", "objects is []"},
        {runs + "objects = \"small-cube\"\n" + model + "seeds = 1\n", ":3: ", "a list of some of"},
        {runs + object + "models = [\"cpg-x\"]\nseeds = 1\n", ":4: ", "a list of some of cpg-s, cpg-m, cpg-c, cpg-h"},
        {runs + object + "seeds = 1\n", ":2: ", "models is missing"},
        {runs + object + model, ":2: ", "seeds is missing; expected a whole number from 1"},
        {runs + object + model + "seeds = [1]\n", ":5: ", "seeds is [1]"},
        {one_block + "centre = true\n", ":6: ", "expected [true], [false] or [true, false]"},
        {one_block + "variant = \"A b\"\n", ":6: ", "expected a name of a-z"},
        {one_block + "variant = \"..\"\n", ":6: ", "expected a name of a-z"},
        {one_block + "variant = \"\"\n", ":6: ", "expected a name of a-z"},
        {one_block + "variant = \"large-cube\"\n", ":6: ", "another name than an object's"},
        {one_block + "set = { \"contact.friction\" = 1 }\n", ":6: ", "set without a variant"},
        {one_block + "variant = \"v\"\nset = 1\n", ":7: ", "set is 1"},
        {one_block + "variant = \"v\"\nset = { contact.friction = 1 }\n", ":7: ", "the names in quotes"},
        {one_block + "variant = \"v\"\nset = { \"contact.grip\" = 1 }\n", ":7: ", "no setting [contact] grip"},
        {one_block + "variant = \"v\"\nset = { \"grip.friction\" = 1 }\n", ":7: ", "no section [grip]"},
        {one_block + "variant = \"v\"\nset = { \"contact.friction\" = 9 }\n", ":7: ", "expected a number from 0 to 5"},
        {one_block + block, ":6: ", "run small-cube/cpg-c/seed-1 is listed twice"},
        {one_block + "centre = [true, true]\n", ":2: ", "listed twice"},
        {one_block + "variant = \"v\"\n" + block + "variant = \"v\"\nset = { \"contact.friction\" = 1 }\n",
         ":11: ", "variant \"v\" has another set than before"},
        {"trials = = 10\n", ":1: ", "no valid TOML"}};
    const ScratchFolder folder;
    for (const auto &[text, line, expected] : cases) {
        const std::string error = error_of([&, &manifest = text] { plan_of_text(folder, manifest); });
        EXPECT_TRUE(is_one_sentence_with(error, {"mine.toml" + line, expected})) << text << "-> " << error;
    }
    const std::string error = error_of([&] { read_sweep_manifest("/nowhere/a.toml", here, some_defaults()); });
    EXPECT_TRUE(is_one_sentence_with(error, {"/nowhere/a.toml", "no such file"})) << error;
}

// sweep.json lists the runs by index and all that decides their numbers.
TEST(SweepManifest, sweep_json_holds_runs_settings_and_variants)
{
    const ScratchFolder folder;
    const SweepPlan plan = plan_of_text(
        folder, one_block + "[[runs]]\nobjects = [\"small-cube\"]\nmodels = [\"cpg-h\"]\ncentre = [false]\nseeds = 1\n"
                            "variant = \"soft\"\nset = { \"contact.friction\" = 0.25 }\n");
    const Json json = sweep_json(plan);
    EXPECT_EQ(json["format"], 1);
    EXPECT_EQ(json["sweep"], "mine");
    EXPECT_EQ(json["trials"], 10);
    EXPECT_EQ(json["setup"], "mid-b");
    EXPECT_EQ(json["settings"]["contact"]["friction"], 0.49); // mid-b's
    EXPECT_EQ(json["variants"].dump(), "{\"soft\":{\"contact.friction\":0.25}}");
    EXPECT_EQ(json["version"].get<std::string>().rfind("twiddle ", 0), 0U);
    ASSERT_EQ(json["runs"].size(), 2U);
    EXPECT_EQ(json["runs"][1].dump(),
              "{\"index\":1,\"folder\":\"soft/small-cube/cpg-h-no-centre/seed-1\",\"object\":\"small-cube\","
              "\"model\":\"cpg-h\",\"centre\":false,\"seed\":1,\"variant\":\"soft\"}");
}

} // namespace
