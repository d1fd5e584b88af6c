// hand_tables.hpp: the controller's tables of the iCub hand, written as C from its URDF.
#pragma once

#include "sim/hand_model.hpp"

#include <string>

namespace twiddle::engine
{

// The text of controller/src/icub_right_hand.c: joint ranges and finger chains (icub_right_hand.h). Numbers are written
// with as many digits as a double needs. Throws std::out_of_range or std::runtime_error if `hand` lacks a joint of the
// tables.
std::string hand_tables(const sim::HandModel &hand);

} // namespace twiddle::engine
