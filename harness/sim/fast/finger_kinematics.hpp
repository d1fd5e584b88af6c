// finger_kinematics.hpp: where the two joint frames of a finger are, and the capsules that they carry.
//
// Positions are in the palm's axes, from the object's centre.
#pragma once

#include "lanes.hpp"
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

// All that one joint carries rigidly, in the joint's frame.
struct CarriedCapsules {
    std::vector<btVector3> points_m;
    std::vector<LinkCapsule> capsules;
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

    // No point of the capsules' centre lines is farther from the axis of joint 0 or 1, however the finger is bent: what
    // a rad of the joint moves it at most.
    double reach_m(int joint) const
    {
        return reach_m_[joint];
    }

    // The first joint's frame at angle 0, and the second's in that one.
    const Frame &first() const
    {
        return first_;
    }
    const Frame &second() const
    {
        return second_;
    }

  private:
    Frame first_;  // at angle 0
    Frame second_; // in the first joint's frame, at angle 0
    std::array<CarriedCapsules, 2> carried_;
    std::array<double, 2> reach_m_{};
};

// A frame of each of two fingers, in lanes.
struct PairFrame {
    PairVector origin_m;
    PairVector x, y, z;
};

// The second joints' frames of two fingers at once.
class PairKinematics
{
  public:
    explicit PairKinematics(const std::array<FingerKinematics, 2> &fingers);

    // As FingerKinematics::frames has them.
    PairFrame second_frames(const std::array<SineCosineOf<Pair>, 2> &angle) const;

  private:
    // A vector that turns with the first joint: constant, times cosine, times sine of its angle.
    struct Turning {
        PairVector constant, by_cosine, by_sine;

        PairVector at(const SineCosineOf<Pair> &angle) const
        {
            return constant + by_cosine * angle.cosine + by_sine * angle.sine;
        }
    };
    using VectorOfFrame = btVector3 Frame::*;
    static Turning turning(const std::array<FingerKinematics, 2> &fingers, VectorOfFrame vector);

    Turning origin_m_, x_, y_, z_; // of the second joints' frames at angle 0
};

} // namespace twiddle::sim
