// finger_kinematics.hpp: where the two joint frames of a finger are, and the capsules that they carry.
//
// Positions are in the palm's axes, from the object's centre.
#pragma once

#include "sim/articulated_hand.hpp"
#include "sine_cosine.hpp"

#include <array>
#include <vector>

namespace twiddle::sim
{

// A frame: its origin and unit axes. A joint turns about its frame's z axis.
struct Frame {
    btVector3 origin_m;
    btVector3 x, y, z;

    btVector3 point(const btVector3 &p_m) const
    {
        return origin_m + direction(p_m);
    }
    btVector3 direction(const btVector3 &v) const
    {
        return v.x() * x + v.y() * y + v.z() * z;
    }
    // The frame turned about its z axis.
    Frame turned(const SineCosine &angle) const
    {
        return {origin_m, angle.cosine * x + angle.sine * y, angle.cosine * y - angle.sine * x, z};
    }
};

// The capsule of a link, or of several links in a straight line, between two of the points that their joint carries.
struct LinkCapsule {
    int start = 0;
    int end = 0;
    double radius_m = 0;
};

// All that one joint carries rigidly, in the joint's frame, and a ball around it (capsule radii included).
struct CarriedCapsules {
    std::vector<btVector3> points_m;
    std::vector<LinkCapsule> capsules;
    btVector3 centre_m;
    double radius_m = 0;
};

// A point as the object's bounding volume sees it.
struct PolarPlace {
    double square_across_m2 = 0; // of the distance from the hinge's axis
    double height_m = 0;         // along it
};

class FingerKinematics
{
  public:
    // The finger whose joints are the Bullet links `first` and `second` of `hand`. Leaves the hand reset.
    FingerKinematics(ArticulatedHand &hand, int first, int second, const btVector3 &p_palm_centre_m);

    // Both joints' frames, turned by their angles.
    std::array<Frame, 2> frames(const std::array<SineCosine, 2> &angle) const;

    // What joint 0 or 1 carries.
    const CarriedCapsules &carried(int joint) const
    {
        return carried_[joint];
    }

    // Where the centre of carried(joint) is, for much less than frames() costs.
    PolarPlace centre(int joint, const std::array<SineCosine, 2> &angle) const;

  private:
    Frame first_;  // at angle 0
    Frame second_; // in the first joint's frame, at angle 0
    std::array<CarriedCapsules, 2> carried_;
    // In the first joint's frame: the centre as a sum [constant, times cosine, times sine of the second angle] for both
    // joints. In the same frame at angle 0: the object's centre and its hinge's direction.
    std::array<std::array<btVector3, 3>, 2> centre_part_m_;
    btVector3 p_first_object_m_;
    btVector3 hinge_direction_;
};

} // namespace twiddle::sim
