// object.hpp: the thing to be turned, as its URDF describes it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::sim
{

enum class Shape { sphere, cylinder, cube };

// Geometry alone; mass, place and friction belong to the set-up (setup.hpp).
struct ObjectSpec {
    std::string name; // e.g. "small-sphere"
    Shape shape = Shape::sphere;
    double size_m = 0;   // what the learner is told: radius of sphere and cylinder, whole diagonal of the cube's base
    double height_m = 0; // along the hinge: 2 radius, the cylinder's length, the cube's side
    double side_m = 0;   // the cube's base; 0 for the others
};

// Read models/objects/NAME.urdf. Throws std::runtime_error with one sentence: an unknown name lists the known ones.
ObjectSpec read_object(const std::filesystem::path &models_dir, const std::string &name);

// The names of all objects in models/objects, in the paper's order (small, medium, large; sphere, cylinder,
// cube), others after.
std::vector<std::string> object_names(const std::filesystem::path &models_dir);

} // namespace twiddle::sim
