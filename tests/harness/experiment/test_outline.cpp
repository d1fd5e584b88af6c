#include "../scratch_folder.hpp"
#include "experiment/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{

using namespace twiddle;
using namespace twiddle::experiment;

sim::ObjectBody body(sim::Shape shape)
{
    sim::ObjectBody body;
    body.shape = shape;
    body.radius_m = 0.03;
    body.height_m = shape == sim::Shape::cube ? 0.02 : 0.04;
    body.side_m = 0.02;
    body.p_palm_centre_m = btVector3(0.04, 0.001, 0.054);
    return body;
}

// Every point of a sphere's outline is one radius from its centre, and the three circles are closed.
TEST(Outline, sphere_points_lie_on_the_sphere)
{
    const auto lines = object_outline(body(sim::Shape::sphere));
    ASSERT_EQ(lines.size(), 3U);
    for (const Polyline &line : lines) {
        EXPECT_LT((line.front() - line.back()).length(), 1e-15);
        for (const btVector3 &point : line) {
            EXPECT_NEAR((point - btVector3(0.04, 0.001, 0.054)).length(), 0.03, 1e-15);
        }
    }
}

// Every point of a cylinder's outline lies on one of its rims: one radius from the axis, half the height
// from the centre.
TEST(Outline, cylinder_points_lie_on_the_rims)
{
    const auto lines = object_outline(body(sim::Shape::cylinder));
    ASSERT_EQ(lines.size(), 6U);
    for (const Polyline &line : lines) {
        for (const btVector3 &point : line) {
            EXPECT_NEAR(std::hypot(point.x() - 0.04, point.y() - 0.001), 0.03, 1e-15);
            EXPECT_NEAR(std::abs(point.z() - 0.054), 0.02, 1e-15);
        }
    }
}

// A cube's outline draws twelve edges, each as long as the side and along one axis.
TEST(Outline, cube_has_twelve_edges_of_one_side)
{
    int edges = 0;
    for (const Polyline &line : object_outline(body(sim::Shape::cube))) {
        for (std::size_t i = 1; i < line.size(); ++i, ++edges) {
            const btVector3 edge = line[i] - line[i - 1];
            EXPECT_NEAR(edge.length(), 0.02, 1e-15);
            EXPECT_NEAR(std::max({std::abs(edge.x()), std::abs(edge.y()), std::abs(edge.z())}), 0.02, 1e-15);
        }
    }
    EXPECT_EQ(edges, 12);
}

// Lines are parted by empty lines in the file: one fewer than there are lines.
TEST(Outline, file_parts_lines_by_empty_lines)
{
    const test::ScratchFolder folder;
    const auto path = folder.path() / "object_outline.csv";
    write_outline(path, object_outline(body(sim::Shape::cube)), {"what"});
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(text.rfind("# what\nx_m,y_m,z_m\n", 0), 0U);
    int parted = 0;
    for (std::size_t at = text.find("\n\n"); at != std::string::npos; at = text.find("\n\n", at + 1)) {
        ++parted;
    }
    EXPECT_EQ(parted, 5);
}

} // namespace
