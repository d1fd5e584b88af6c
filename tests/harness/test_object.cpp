// The objects' URDFs, own ones, and how unfit ones are refused.
#include "scratch_folder.hpp"

#include "sim/object.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace twiddle
{
namespace
{

using sim::ObjectSpec;
using sim::Shape;

ObjectSpec object(const std::string &name)
{
    return sim::read_object(TWIDDLE_MODELS, name);
}

std::string object_urdf(const std::string &geometry, const std::string &origin = "")
{
    return "<robot name=\"own\"><link name=\"own\"><collision>" + origin + "<geometry>" + geometry +
           "</geometry></collision></link></robot>";
}

// Expected: Ciancio et al. 2011; 2.8, 3.2 and 3.6 cm as radius of sphere and cylinder, diagonal of the cube's base.
TEST(object, sizes_are_the_papers)
{
    const std::vector<std::pair<std::string, double>> sizes = {{"small", 0.028}, {"medium", 0.032}, {"large", 0.036}};
    for (const auto &[size, size_m] : sizes) {
        const ObjectSpec sphere = object(size + "-sphere");
        EXPECT_EQ(sphere.shape, Shape::sphere);
        EXPECT_DOUBLE_EQ(sphere.size_m, size_m);
        EXPECT_DOUBLE_EQ(sphere.height_m, 2 * size_m);
        const ObjectSpec cylinder = object(size + "-cylinder");
        EXPECT_EQ(cylinder.shape, Shape::cylinder);
        EXPECT_DOUBLE_EQ(cylinder.size_m, size_m);
        EXPECT_DOUBLE_EQ(cylinder.height_m, 0.04);
        const ObjectSpec cube = object(size + "-cube");
        EXPECT_EQ(cube.shape, Shape::cube);
        EXPECT_DOUBLE_EQ(cube.size_m, size_m);
        EXPECT_DOUBLE_EQ(cube.side_m, size_m / std::sqrt(2));
        EXPECT_DOUBLE_EQ(cube.height_m, cube.side_m);
        EXPECT_EQ(cube.name, size + "-cube");
    }
}

// The order of object.hpp: small, medium, large; sphere, cylinder, cube; own objects after.
TEST(object, names_are_in_the_papers_order_and_own_objects_follow)
{
    const auto names = sim::object_names(TWIDDLE_MODELS);
    const std::vector<std::string> expected = {"small-sphere",  "small-cylinder",  "small-cube",
                                               "medium-sphere", "medium-cylinder", "medium-cube",
                                               "large-sphere",  "large-cylinder",  "large-cube"};
    ASSERT_GE(names.size(), expected.size());
    EXPECT_EQ(std::vector<std::string>(names.begin(), names.begin() + 9), expected);

    const test::ScratchFolder models;
    for (const char *name : {"b-knob", "large-cube", "a-knob", "small-cylinder"}) {
        models.write(std::string("objects/") + name + ".urdf", object_urdf("<sphere radius=\"0.02\"/>"));
    }
    const std::vector<std::string> own = {"small-cylinder", "large-cube", "a-knob", "b-knob"};
    EXPECT_EQ(sim::object_names(models.path()), own);
}

// A box with a square base is read as the cube's shape, with a height of its own.
TEST(object, an_own_object_is_read)
{
    const test::ScratchFolder models;
    models.write("objects/knob.urdf", object_urdf("<box size=\"0.03 0.03 0.05\"/>"));
    const ObjectSpec knob = sim::read_object(models.path(), "knob");
    EXPECT_EQ(knob.name, "knob");
    EXPECT_EQ(knob.shape, Shape::cube);
    EXPECT_DOUBLE_EQ(knob.side_m, 0.03);
    EXPECT_DOUBLE_EQ(knob.height_m, 0.05);
    EXPECT_NEAR(knob.size_m, 0.042426406871, 1e-12); // 0.03 sqrt 2
}

TEST(object, an_unknown_name_lists_the_known_ones)
{
    for (const char *name : {"tiny-sphere", "../objects/small-sphere", ""}) {
        const std::string error = test::error_of([&] { object(name); });
        EXPECT_TRUE(test::is_one_sentence_with(error, {std::string("\"") + name + "\"", "small-sphere", "large-cube"}))
            << error;
    }
}

TEST(object, unfit_objects_are_refused_in_one_sentence)
{
    const test::ScratchFolder models;
    const std::vector<std::pair<std::string, std::string>> faults = {
        {object_urdf("<box size=\"0.03 0.04 0.05\"/>"), "equal x and y sides"},
        {object_urdf("<mesh filename=\"knob.stl\"/>"), "sphere, a cylinder or a box"},
        {object_urdf("<sphere radius=\"0\"/>"), "above 0 m"},
        {object_urdf("<sphere radius=\"wide\"/>"), "no valid URDF"},
        {object_urdf("<sphere radius=\"0.03\"/>", "<origin xyz=\"0 0 0.01\"/>"), "centred on the origin"},
        {object_urdf("<box size=\"0.03 0.03 0.03\"/>", "<origin rpy=\"0.5 0 0\"/>"), "not be turned"},
        {"<robot name=\"own\"><link name=\"own\"/></robot>", "one <collision> shape"},
        {"<robot name=\"own\"><link name=\"own\">", "no valid URDF"},
        {"", "no valid URDF"},
        {"<robot name=\"own\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"fixed\"><parent link=\"a\"/>"
         "<child link=\"b\"/></joint></robot>",
         "one link"}};
    for (const auto &[text, reason] : faults) {
        const auto path = models.write("objects/knob.urdf", text);
        const std::string error = test::error_of([&] { sim::read_object(models.path(), "knob"); });
        EXPECT_TRUE(test::is_one_sentence_with(error, {path.string() + ":", reason})) << error;
    }
}

} // namespace
} // namespace twiddle
