// outline.hpp: the object's outline as lines in space, at angle 0, for figures.
#pragma once

#include "sim/object_body.hpp"

#include <LinearMath/btVector3.h>

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::experiment
{

// Points in the palm frame, m, joined one after the other.
using Polyline = std::vector<btVector3>;

// A sphere: three great circles. A cylinder: two rims and four lines between them. A cube: its twelve edges.
std::vector<Polyline> object_outline(const sim::ObjectBody &body);

// Write object_outline.csv under `comments`: columns x_m, y_m, z_m; an empty line parts two polylines.
void write_outline(const std::filesystem::path &path, const std::vector<Polyline> &outline,
                   const std::vector<std::string> &comments);

// What the body is, as lines "object_shape: sphere" for the head of a file.
std::vector<std::string> object_facts(const std::string &name, double size_m, const sim::ObjectBody &body);

// What is fixed in a trial beside the body, as such lines: which turn about the hinge counts, the radius of rounded
// edges, and the angles of the joints that are held. With the hand's URDF and the joint angles that move, they are
// enough to draw the trial.
std::vector<std::string> fixed_facts(const settings::Setup &setup, const sim::ObjectBody &body);

} // namespace twiddle::experiment
