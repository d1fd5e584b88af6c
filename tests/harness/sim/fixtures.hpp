// fixtures.hpp: what the simulation's tests share.
#pragma once

#include "setups.hpp"
#include "sim/articulated_hand.hpp"
#include "sim/hand_model.hpp"

#include <random>
#include <string>
#include <vector>

namespace twiddle::sim
{

inline HandModel icub_hand()
{
    return read_hand_model(std::string(TWIDDLE_MODELS) + "/icub_right_hand.urdf");
}

inline settings::Setup default_setup(const std::vector<settings::Override> &overrides = {})
{
    return test::load_setup("mid-a", overrides);
}

// Angles of a hand's moving joints, in the order of its links, uniform in their ranges.
inline std::vector<double> random_posture(const ArticulatedHand &hand, std::mt19937_64 &random)
{
    std::vector<double> angle_rad;
    for (const ArticulatedLink &link : hand.links()) {
        if (!link.moves) continue;
        const HandLink &model = hand.model().links[link.model_link];
        angle_rad.push_back(std::uniform_real_distribution<double>(model.lower_rad, model.upper_rad)(random));
    }
    return angle_rad;
}

} // namespace twiddle::sim
