#include "view/index_page.hpp"

#include "../scratch_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace
{

using namespace twiddle;

view::IndexCell cell(const std::string &object, const std::string &model, std::uint64_t seed, double rotation_rad)
{
    view::IndexCell made;
    made.run.object = object;
    made.run.model = model;
    made.run.seed = seed;
    made.run.folder = object + "/" + model + "/seed-" + std::to_string(seed);
    made.rotation_rad = rotation_rad;
    made.has_page = true;
    return made;
}

bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

// Expected: each number stands in the table as a link to its run, also where rotations have two signs.
TEST(IndexPage, cells_say_their_rotation_and_open_their_replay)
{
    const view::SweepView sweep = {
        "smoke", "twiddle 1", {cell("small-sphere", "cpg-h", 1, 3.7924), cell("large-cube", "cpg-h", 2, -1.5)}};
    const std::string page = view::index_page(sweep);
    EXPECT_TRUE(contains(page, "<a href=\"./small-sphere/cpg-h/seed-1/replay.html\">3.79</a>")) << page;
    EXPECT_TRUE(contains(page, "<a href=\"./large-cube/cpg-h/seed-2/replay.html\">-1.50</a>")) << page;
    EXPECT_TRUE(contains(page, "CPG-H"));
    EXPECT_TRUE(contains(page, "2 of 2"));
}

// Expected: a run that is not complete, or whose replay had a fault, is in the table without a link.
TEST(IndexPage, runs_without_a_replay_are_said)
{
    view::SweepView sweep = {
        "smoke", "", {cell("a", "cpg-h", 1, 1), cell("a", "cpg-h", 2, 1), cell("a", "cpg-h", 3, 1)}};
    sweep.cells[1].rotation_rad.reset();
    sweep.cells[1].has_page = false;
    sweep.cells[2] = sweep.cells[1];
    sweep.cells[2].run.seed = 3;
    sweep.cells[2].fault = "it <flew> away";
    const std::string page = view::index_page(sweep);
    EXPECT_TRUE(contains(page, "not complete"));
    EXPECT_TRUE(contains(page, "<td title=\"it &lt;flew&gt; away\">fault</td>"));
    EXPECT_FALSE(contains(page, "seed-2/replay.html"));
    EXPECT_TRUE(contains(page, "1 of 3"));
}

// Expected: names are text, whatever is in them.
TEST(IndexPage, names_stay_text)
{
    view::IndexCell odd = cell("</td><script>", "<b>", 1, 1);
    odd.run.variant = "\"><script>";
    const std::string page = view::index_page({"<script>", "<script>", {odd}});
    EXPECT_FALSE(contains(page, "<script"));
    EXPECT_FALSE(contains(page, "<b>"));
}

// A page is written into each run's folder; expected: a list that leads elsewhere is refused.
TEST(SweepView, folder_outside_of_the_sweep_is_refused)
{
    for (const std::string outside : {"../other", "/tmp/other", "a/../../other"}) {
        const test::ScratchFolder folder;
        folder.write("sweep.json",
                     R"({"format": 1, "sweep": "s", "version": "v", "trials": 1, "runs": [{"folder": ")" + outside +
                         R"(", "variant": "", "object": "o", "model": "m", "centre": true, "seed": 1}]})");
        const std::string error = test::error_of([&] { view::read_sweep_view(folder.path()); });
        EXPECT_TRUE(test::is_one_sentence_with(error, {outside, "not below"})) << error;
    }
}

} // namespace
