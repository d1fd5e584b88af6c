// object_body.hpp: the object as a set-up places it in the world.
#pragma once

#include "object.hpp"
#include "settings/setup.hpp"

#include <LinearMath/btVector3.h>

namespace twiddle::sim
{

// The object as it stands in the world: its outer dimensions, rounding included, and its moment of inertia.
struct ObjectBody {
    Shape shape = Shape::sphere;
    double radius_m = 0;   // sphere and cylinder
    double height_m = 0;   // along the hinge
    double side_m = 0;     // the cube's base
    double rounding_m = 0; // radius of the rounded edges, within the outer dimensions; a sphere has none
    btVector3 p_palm_centre_m;
    double inertia_kg_m2 = 0; // about the hinge
};

// The set-up's reading of an object: cylinder height, cube size, place, mass.
ObjectBody object_body(const ObjectSpec &spec, const settings::ObjectSetup &setup);

} // namespace twiddle::sim
