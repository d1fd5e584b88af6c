// fast_world.hpp: the world on reduced finger dynamics, closed-form distances and an exact contact solver.
//
// Two fingers of two joints each and one hinge make five coordinates. A substep is semi-implicit Euler with contact
// impulses, as Bullet's world does it:
//     M(q) (v' - v) / h = torque - bias(q, v) - gravity(q) + J^T p / h,    q' = q + h v'
// finger_dynamics.hpp has M and the bias, finger_kinematics.hpp J, segment_contacts.hpp the distances,
// contact_solver.hpp and hinge_friction.hpp the impulses p.
#pragma once

#include "sim/world.hpp"

namespace twiddle::sim
{

// Throws std::runtime_error if the straight hand touches the object, and NotCovered, naming the reference stepper, if
// the hand is not two fingers of two moving joints each or if fingers may touch each other.
std::unique_ptr<World> make_fast_world(const HandModel &hand, const ObjectSpec &object, const settings::Setup &setup,
                                       HandHold hold);

} // namespace twiddle::sim
