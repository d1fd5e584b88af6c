#include "../scratch_folder.hpp"
#include "program.hpp"
#include "record/json_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

namespace
{

using namespace twiddle::test;
using twiddle::record::Json;
namespace fs = std::filesystem;

// A complete run of a few trials.
class ExportCommand : public testing::Test
{
  protected:
    void SetUp() override
    {
        run_ = folder_.path() / "run";
        const Outcome outcome =
            run_twiddle("train --object medium-cube --model cpg-c --seed 3 --trials 5 --out " + run_.string());
        ASSERT_EQ(outcome.status, 0) << outcome.error;
    }

    Outcome export_run(const std::string &more = "--c-header") const
    {
        return run_twiddle("export " + run_.string() + " " + more);
    }

    // Change run.json or policy.json.
    void edit(const std::string &name, const std::function<void(Json &)> &change) const
    {
        Json json = twiddle::record::read_json(run_ / name);
        change(json);
        twiddle::record::write_json(run_ / name, json);
    }

    void expect_refused(int status, const std::string &part, const std::string &more = "--c-header") const
    {
        const Outcome outcome = export_run(more);
        EXPECT_EQ(outcome.status, status) << outcome.error;
        EXPECT_TRUE(is_one_complaint(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find(part), std::string::npos) << outcome.error;
        EXPECT_EQ(outcome.output, "");
    }

    ScratchFolder folder_;
    fs::path run_;
};

bool holds(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

// The header says where it comes from, and goes to standard output or, the same, to a file.
TEST_F(ExportCommand, header_names_its_source)
{
    const Outcome outcome = export_run();
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    for (const char *part :
         {"cpg-c with centre turns medium-cube: learned in 5 trials from seed 3", "Set-up paper", "twiddle 0.",
          "#ifndef TWIDDLE_SKILL_MEDIUM_CUBE_CPG_C_H\n#define TWIDDLE_SKILL_MEDIUM_CUBE_CPG_C_H\n",
          "static const struct twd_skill medium_cube_cpg_c_skill = {",
          "static const struct twd_learner_snapshot medium_cube_cpg_c_learner = {"}) {
        EXPECT_TRUE(holds(outcome.output, part)) << part;
    }
    EXPECT_FALSE(holds(outcome.output, "do not reach"));

    const fs::path file = folder_.path() / "skill.h";
    const Outcome written = export_run("--c-header --out " + file.string());
    EXPECT_EQ(written.status, 0) << written.error;
    EXPECT_EQ(written.output, "written: " + file.string() + "\n");
    EXPECT_EQ(text_of(file), outcome.output);
}

// Guard and names begin as --name says; what is no start of names in C and C++ is refused.
TEST_F(ExportCommand, names_can_be_chosen)
{
    const Outcome outcome = export_run("--c-header --name Twist_2");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_TRUE(holds(outcome.output, "#ifndef TWIDDLE_SKILL_TWIST_2_H\n"));
    EXPECT_TRUE(holds(outcome.output, "static const struct twd_skill Twist_2_skill = {"));
    EXPECT_FALSE(holds(outcome.output, "medium_cube_cpg_c"));
    for (const char *name : {"2twist", "_twist", "twist_", "a__b", "a-b", "a*/b"}) {
        expect_refused(2, std::string("no names in C can begin with '") + name + "'",
                       std::string("--c-header --name '") + name + "'");
    }
}

// A number that the fixed build's formats do not reach is named: a stiffness of 9 N m/rad, where they end at 8.
TEST_F(ExportCommand, numbers_beyond_the_fixed_build_are_named)
{
    edit("run.json", [](Json &run) { run["settings"]["hand"]["stiffness_nm_per_rad"]["ot"] = 9; });
    const Outcome outcome = export_run();
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_TRUE(holds(outcome.output, "do not reach all of these numbers, which are at their ends there: such as\n"
                                      " * TWD_NUM_CONSTANT(9, 2147483647)."));
}

TEST_F(ExportCommand, only_complete_runs_are_taken)
{
    expect_refused(2, "--c-header is required", "");
    const Outcome elsewhere = run_twiddle("export " + folder_.path().string() + " --c-header");
    EXPECT_EQ(elsewhere.status, 2);
    EXPECT_TRUE(is_one_complaint(elsewhere.error)) << elsewhere.error;
    EXPECT_TRUE(holds(elsewhere.error, "is no folder of a run: it holds no run.json")) << elsewhere.error;

    edit("run.json", [](Json &run) { run["state"] = "running"; });
    expect_refused(2, "is not complete; finish it by train --resume");
    edit("run.json", [](Json &run) { run["state"] = "complete"; });
    fs::rename(run_ / "policy.json", run_ / "away");
    expect_refused(2, "holds no policy.json: its training is not complete; finish it by train --resume");
    folder_.write("run/policy.json", "{");
    expect_refused(1, "is not valid JSON");
}

// A policy.json whose learner is none of the run's is refused by key, and nothing is written.
TEST_F(ExportCommand, policy_of_another_learner_is_refused)
{
    const std::string policy = text_of(run_ / "policy.json");
    const auto refused = [&](const std::string &key, const std::function<void(Json &)> &change) {
        edit("policy.json", change);
        expect_refused(1, "policy.json': '" + key + "'", "--c-header --out " + (folder_.path() / "skill.h").string());
        folder_.write("run/policy.json", policy);
    };
    refused("parameters", [](Json &json) { json["parameters"].erase("cpg-c.frequency"); });
    refused("trials", [](Json &json) { json["trials"] = 4; });
    refused("actor_weights", [](Json &json) { json["learner"]["actor_weights"].erase(0); });
    refused("critic_weights", [](Json &json) { json["learner"]["critic_weights"].erase(0); });
    refused("critic_weights", [](Json &json) { json["learner"]["actor_weights"][11].push_back(0.5); });
    refused("random_state", [](Json &json) { json["learner"]["random_state"] = {0, 0, 0, 0}; });
    EXPECT_FALSE(fs::exists(folder_.path() / "skill.h"));
    EXPECT_EQ(export_run().status, 0);
}

// A header that cannot be written to its end leaves an earlier one as it was.
TEST_F(ExportCommand, file_that_cannot_be_written_stays)
{
    const fs::path file = folder_.write("skill.h", "earlier");
    const std::string command = "export " + run_.string() + " --c-header --out ";
    const Outcome full = run_twiddle_on_full_disk(command + file.string(), 4);
    EXPECT_EQ(full.status, 1);
    EXPECT_TRUE(is_one_complaint(full.error)) << full.error;
    EXPECT_EQ(text_of(file), "earlier");
    expect_refused(1, "cannot write", "--c-header --out " + (folder_.path() / "nowhere" / "skill.h").string());
}

} // namespace
