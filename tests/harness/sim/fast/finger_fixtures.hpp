// finger_fixtures.hpp: one finger of the welded hand, as Bullet has it and as the fast stepper's pieces take it.
#pragma once

#include "../fixtures.hpp"

#include "sim/fast/finger_dynamics.hpp"
#include "sim/fast/finger_kinematics.hpp"
#include "sim/world.hpp"

#include "setups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <tuple>

namespace twiddle::sim
{

// Set-up, angle of the held distal joints in degrees, finger.
using FingerCase = std::tuple<const char *, int, Finger>;

inline auto all_finger_cases()
{
    return testing::Combine(testing::Values("mid-a", "mid-b", "near"), testing::Values(0, 20),
                            testing::Values(Finger::index, Finger::thumb));
}

inline std::string name_of(const testing::TestParamInfo<FingerCase> &info)
{
    const auto [setup, distal_deg, finger] = info.param;
    std::string name = std::string(finger == Finger::index ? "index_of_" : "thumb_of_") + setup + "_distal_" +
                       std::to_string(distal_deg) + "_deg";
    std::replace(name.begin(), name.end(), '-', '_'); // GoogleTest's names have no hyphens
    return name;
}

inline settings::Setup setup_with_distal(const std::string &setup, int distal_deg)
{
    const std::string angle = std::to_string(distal_deg);
    return test::load_setup(setup, {{"hand.index_distal_deg", angle}, {"hand.thumb_distal_deg", angle}});
}

class BulletFinger
{
  public:
    BulletFinger(const settings::Setup &setup, Finger finger)
        : gravity_m_s2(gravity_palm_m_s2(icub_hand(), setup.physics)),
          hand(icub_hand(), setup.hand, HandHold::welded), link{hand.controlled()[finger == Finger::index ? aai : ot],
                                                                hand.controlled()[finger == Finger::index ? fei : fet]}
    {
        for (const ArticulatedLink &part : hand.links()) {
            if (!part.moves) continue;
            for (int j = 0; j < 2; j++) {
                if (part.body_link != link[j]) continue;
                lower_rad[j] = hand.model().links[part.model_link].lower_rad;
                upper_rad[j] = hand.model().links[part.model_link].upper_rad;
            }
        }
    }

    // Turn the finger's joints; all link frames follow.
    void set_angles(const FingerVector &angle_rad)
    {
        for (int j = 0; j < 2; j++)
            hand.body().setJointPos(link[j], angle_rad[j]);
        hand.place_colliders();
    }

    // Angles uniform in the joints' ranges and `beyond_rad` further.
    FingerVector random_angles(std::mt19937_64 &random, double beyond_rad) const
    {
        FingerVector angle_rad;
        for (int j = 0; j < 2; j++)
            angle_rad[j] =
                std::uniform_real_distribution<double>(lower_rad[j] - beyond_rad, upper_rad[j] + beyond_rad)(random);
        return angle_rad;
    }

    const btVector3 gravity_m_s2; // palm frame
    ArticulatedHand hand;
    const std::array<int, 2> link; // Bullet links of the two joints, from the palm outwards
    FingerVector lower_rad{}, upper_rad{};
};

inline std::array<SineCosine, 2> sines_cosines(const FingerVector &angle_rad)
{
    return {sine_cosine(angle_rad[0]), sine_cosine(angle_rad[1])};
}

// Uniform between -`largest` and `largest`.
inline FingerVector random_pair(std::mt19937_64 &random, double largest)
{
    std::uniform_real_distribution<double> uniform(-largest, largest);
    const double first = uniform(random);
    return {first, uniform(random)};
}

} // namespace twiddle::sim
