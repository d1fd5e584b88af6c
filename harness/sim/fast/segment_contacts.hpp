// segment_contacts.hpp: where a finger's capsule comes near the object, exactly and in nanoseconds.
//
// The capsule is given by its centre line, a segment; its radius is the caller's to subtract. Every function works in
// the object's frame: origin at the object's centre, z along the hinge, turned with the object. Nothing here allocates
// or throws, and the same input gives the same output.
#pragma once

#include "lanes.hpp"
#include "sim/object_body.hpp"

#include <array>

namespace twiddle::sim
{

// The object as distances see it: a core (the shape shrunk by its rounding) with a skin of `rounding_m` around it.
// A sphere's core is its centre.
struct RoundedCore {
    Shape shape = Shape::sphere;
    double radius_m = 0;          // the cylinder's core, above 0; else 0
    double half_side_m = 0;       // the cube's core; else 0
    double half_height_m = 0;     // cylinder's and cube's core, along z; else 0
    double rounding_m = 0;        // a sphere's whole radius
    double bounding_radius_m = 0; // about z, of all the object however it is turned, rounding included
};

// The core of an object whose rounding is less than its radius and half of its other dimensions.
RoundedCore rounded_core(const ObjectBody &body);

// What a contact belongs to. It names a contact from one step to the next, so that a solver may start
// from its last force.
enum ContactFeature {
    contact_closest,    // the closest point, where it is none of those below
    contact_start,      // the segment's start
    contact_end,        // the segment's end
    contact_first_clip, // where the segment comes over the face that the closest point lies on
    contact_second_clip // where it leaves it
};
constexpr int contact_features = 5;

// A point of the segment near the object.
struct SegmentContact {
    double share;      // place on the segment, 0 start .. 1 end
    Vector normal;     // unit, out of the object
    double distance_m; // from the object's rounded surface to the point; negative if the point lies inside
    int feature;       // a ContactFeature
};

struct SegmentContacts {
    std::array<SegmentContact, 4> contact; // the first `count` are set
    int count = 0;
};

// The points of the segment that hold it on the object, those nearer than `reach_m` (above 0): first the closest point,
// then, for cylinder and cube, the segment's ends and the points where it comes over and leaves the face that the
// closest point lies on. Each has its own normal and distance. Points within 0.1 mm of each other on the segment count
// as one: a closest point at an end or a clip point stands first under that point's feature, and keeps its own place.
// Of more than four points the farthest is left out.
//
// A segment of no length is a point. A point inside the core has the normal and the distance of the shortest way out
// (along x from the very axis or centre); of a segment through the core, the middle of the part inside stands first.
//
// Returns a distance from the surface, m, that no point of the segment is nearer than: the closest point's own, or less
// if it is out of reach.
double find_segment_contacts(const RoundedCore &core, const Vector &start_m, const Vector &end_m, double reach_m,
                             SegmentContacts &contacts);

} // namespace twiddle::sim
