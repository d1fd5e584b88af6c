// clearance.hpp: libccd's view of fingers and object, independent of Bullet's collision detection.
//
// It proves before a run that the straight hand is clear of the object, and judges Bullet's contacts in tests.
#pragma once

#include "articulated_hand.hpp"
#include "object_body.hpp"

#include <optional>

namespace twiddle::sim
{

// How far two shapes reach into each other.
struct Overlap {
    double depth_m = 0;
    btVector3
        direction; // unit, from the object's surface towards the capsule: pushing the capsule this way separates them
};

// Overlap of a capsule (centre line from `start_m` to `end_m`, palm frame) with an object at `angle_rad`; nothing if
// they are apart. Minkowski portal refinement of libccd, tolerance 1e-7 m.
std::optional<Overlap> capsule_overlap(const ObjectBody &object, double angle_rad, const btVector3 &start_m,
                                       const btVector3 &end_m, double radius_m);

// Throws std::runtime_error naming link, object and depth if any link of `hand`, as it stands, touches the object.
void require_clearance(const ArticulatedHand &hand, const ObjectBody &object, const std::string &object_name);

// Smallest distance between the surfaces of index and thumb, m; negative if they overlap.
double finger_clearance_m(const ArticulatedHand &hand);

} // namespace twiddle::sim
