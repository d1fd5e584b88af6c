// reference_world.hpp: the world on Bullet's multibody dynamics, collision detection and constraint rows.
#pragma once

#include "sim/world.hpp"

namespace twiddle::sim
{

// Throws std::runtime_error if the straight hand touches the object.
std::unique_ptr<World> make_reference_world(const HandModel &hand, const ObjectSpec &object,
                                            const settings::Setup &setup, HandHold hold);

} // namespace twiddle::sim
