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

// A link's capsule, in the frame of the joint that carries it.
struct LinkCapsule {
    btVector3 start_m;
    btVector3 end_m;
    double radius_m = 0;
};

// All that one joint carries rigidly, and a sphere around it (capsule radii included).
struct CarriedCapsules {
    std::vector<LinkCapsule> capsules;
    btVector3 centre_m;
    double radius_m = 0;
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

  private:
    Frame first_;  // at angle 0
    Frame second_; // in the first joint's frame, at angle 0
    std::array<CarriedCapsules, 2> carried_;
};

} // namespace twiddle::sim
