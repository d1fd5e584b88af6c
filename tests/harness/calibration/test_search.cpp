#include "calibration/search.hpp"

#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace
{

using namespace twiddle::calibration;

const std::vector<Variable> three = {
    {"a.a", 0, 1, false, {}}, {"a.b", 0, 1, false, {}}, {"a.c", 0, 0, false, {"one", "other"}}};

bool anything_fits(const Point &)
{
    return true;
}

// A bowl around (0.8, 0.2), deeper for the first value of the list.
double bowl(const Point &point)
{
    return (point[0] - 0.8) * (point[0] - 0.8) + (point[1] - 0.2) * (point[1] - 0.2) + (point[2] < 0.5 ? 0 : 1);
}

std::vector<Point> points_of(Search &search)
{
    std::vector<Point> points;
    while (!search.is_done()) {
        points.push_back(search.next());
        search.tell(bowl(points.back()));
    }
    return points;
}

TEST(Search, a_seed_gives_the_same_points_and_another_seed_others)
{
    Search first({7, 20, 20, 4}, three, anything_fits);
    Search second({7, 20, 20, 4}, three, anything_fits);
    Search other({8, 20, 20, 4}, three, anything_fits);
    const std::vector<Point> points = points_of(first);
    EXPECT_EQ(points.size(), 40U);
    EXPECT_EQ(points, points_of(second));
    EXPECT_NE(points, points_of(other));
}

// Each of the four quarters of a plane gets 250 of 1,000 uniform points, with a standard deviation of 14.
TEST(Search, random_points_fill_the_cube_evenly)
{
    Search search({1, 1000, 0, 1}, three, anything_fits);
    std::array<int, 4> quarter{};
    for (const Point &point : points_of(search)) {
        ++quarter[(point[0] < 0.5 ? 0 : 1) + (point[1] < 0.5 ? 0 : 2)];
    }
    for (const int count : quarter) {
        EXPECT_NEAR(count, 250, 5 * 14);
    }
}

// 30 random points are some 0.1 apart; the refined ones must come nearer to a bowl's bottom than the best of them.
TEST(Search, refined_points_come_nearer_to_the_bottom_of_a_bowl)
{
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        Search search({seed, 30, 60, 5}, three, anything_fits);
        const std::vector<Point> points = points_of(search);
        const auto best_of = [&](std::size_t from, std::size_t to) {
            double best = std::numeric_limits<double>::infinity();
            for (std::size_t i = from; i < to; ++i) {
                best = std::min(best, bowl(points[i]));
            }
            return best;
        };
        EXPECT_LT(best_of(30, 90), best_of(0, 30)) << "seed " << seed;
        EXPECT_EQ(bowl(search.point(search.ranking().front())), best_of(0, 90));
    }
}

TEST(Search, only_points_that_fit_are_given)
{
    Search search({1, 50, 50, 5}, three, [](const Point &point) { return point[0] + point[1] < 0.3; });
    for (const Point &point : points_of(search)) {
        EXPECT_LT(point[0] + point[1], 0.3);
        EXPECT_TRUE(std::all_of(point.begin(), point.end(), [](double value) { return value >= 0 && value <= 1; }));
    }
}

TEST(Search, says_that_nothing_fits)
{
    Search search({1, 1, 0, 1}, three, [](const Point &) { return false; });
    EXPECT_TRUE(twiddle::test::is_one_sentence_with(twiddle::test::error_of([&] { search.next(); }), {"widen"}));
}

TEST(Search, the_ranking_is_by_error_and_puts_infinite_ones_last)
{
    Search search({1, 4, 0, 1}, three, anything_fits);
    for (const double error : {0.5, std::numeric_limits<double>::infinity(), 0.25, 0.5}) {
        search.next();
        search.tell(error);
    }
    EXPECT_EQ(search.ranking(), (std::vector<std::size_t>{2, 0, 3, 1}));
}

} // namespace
