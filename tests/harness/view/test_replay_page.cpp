#include "view/replay_page.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace
{

using namespace twiddle;

// A run of `steps` with one link on the palm, all its texts `text`.
view::RunView made_up_run(int steps, const std::string &text)
{
    view::RunView run;
    run.title = text;
    run.facts = {{text, text}};
    run.object.name = text;
    run.object.shape = "sphere";
    run.object.radius_m = 0.028;
    run.object.height_m = 0.056;
    run.object.counted_direction = -1;
    run.links.resize(20);
    for (int i = 1; i <= steps; ++i) {
        view::StepView step;
        step.angle_rad = {0.12345, -0.2, 0.3, 1.9};
        step.rotation_rad = i / 100.0;
        step.index_force_n = 0.25;
        step.p_palm_index_tip_m = btVector3(0.080754, -0.034593, -0.008955);
        run.steps.push_back(step);
    }
    return run;
}

std::string data_of(const std::string &page)
{
    const std::string begin = "id=\"data\">";
    const std::size_t at = page.find(begin) + begin.size();
    return page.substr(at, page.find("</script>", at) - at);
}

std::size_t count(const std::string &text, const std::string &part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

// Expected: angles to 0.0001 rad, forces to a mN, positions to 0.01 mm.
TEST(ReplayPage, holds_every_step_rounded)
{
    const auto data = nlohmann::json::parse(data_of(view::replay_page({made_up_run(300, "run")})));
    ASSERT_EQ(data.size(), 1U);
    ASSERT_EQ(data[0]["rows"].size(), 300U);
    EXPECT_EQ(data[0]["rows"][99],
              nlohmann::json({1235, -2000, 3000, 19000, 10000, 250, 0, 8075, -3459, -896, 0, 0, 0}));
    EXPECT_EQ(data[0]["object"]["direction"], -1);
}

// Expected: below 100 kB a run, and no address that a browser would ask.
TEST(ReplayPage, is_small_and_asks_for_nothing)
{
    const std::string page = view::replay_page({made_up_run(300, "run"), made_up_run(300, "other")});
    EXPECT_LT(page.size(), 200000U);
    for (const char *part : {"http:", "https:", "src=", "url(", "@import", "fetch(", "XMLHttpRequest", "WebSocket"}) {
        EXPECT_EQ(page.find(part), std::string::npos) << part;
    }
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

// Expected: texts that would end a script, or begin one, appear as text: as many elements as in a page without.
TEST(ReplayPage, text_of_a_run_stays_text)
{
    const std::string text = "</script><script>alert(1)</script><!--\u2028@DATA@&\"'";
    const std::string plain = view::replay_page({made_up_run(3, "run")});
    const std::string page = view::replay_page({made_up_run(3, text)});
    for (const char *part : {"<script", "</script", "<!--", "\u2028"}) {
        EXPECT_EQ(count(page, part), count(plain, part)) << part;
    }
    const auto data = nlohmann::json::parse(data_of(page));
    EXPECT_EQ(data[0]["title"], text);
    EXPECT_EQ(data[0]["facts"][0][1], text);
}

// Expected: what a test in a browser and a reader with a keyboard look for, once each.
TEST(ReplayPage, has_its_controls)
{
    const std::string page = view::replay_page({made_up_run(3, "run")});
    for (const char *id : {"play", "speed", "scrub", "chart", "no-webgl"}) {
        EXPECT_EQ(count(page, "id=\"" + std::string(id) + "\""), 1U) << id;
    }
}

} // namespace
