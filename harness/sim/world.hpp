// world.hpp: a hand and a hinged object, stepped by torques. Two steppers stand behind it (make_world).
//
// The world is in the palm frame (hand_model.hpp). It knows nothing of CPGs, trials or rewards. A world that was reset
// continues exactly as a new one does.
#pragma once

#include "articulated_hand.hpp"
#include "hand_model.hpp"
#include "not_covered.hpp"
#include "object.hpp"
#include "settings/joints.hpp"
#include "settings/setup.hpp"

#include <memory>
#include <string>
#include <vector>

namespace twiddle::sim
{

// Gravity in the palm frame of `hand`.
btVector3 gravity_palm_m_s2(const HandModel &hand, const settings::PhysicsSetup &setup);

// What can be seen of the world after a substep. All in the palm frame.
struct Observation {
    JointVector angle_rad{};
    JointVector velocity_rad_s{};
    btVector3 p_palm_index_tip_m; // centre of the fingertip's end sphere
    btVector3 p_palm_thumb_tip_m;
    double object_rad = 0;      // in the counted direction, not wrapped
    double index_contact_n = 0; // sum of the normal forces of the finger's contacts over the last substep
    double thumb_contact_n = 0;
    double deepest_m = 0;          // deepest penetration of a finger into the object, >= 0
    double finger_clearance_m = 0; // smallest distance between index and thumb
};

class World
{
  public:
    World() = default;
    World(const World &) = delete;
    World &operator=(const World &) = delete;
    virtual ~World() = default;

    // Back to the start: all joints at 0 (held ones at their angles), everything at rest.
    virtual void reset() = 0;

    // Advance by one substep of 10 ms / substeps under the torques `torque_nm` (limited to the set-up's torque limit).
    virtual void substep(const JointVector &torque_nm) = 0;

    // The controlled joints; cheap, for the PD law at every substep.
    virtual JointVector angles_rad() const = 0;
    virtual JointVector velocities_rad_s() const = 0;

    // The object's rotation, in the counted direction.
    virtual double object_rotation_rad() const = 0;

    // Everything; call it once a control step.
    virtual Observation observe() const = 0;

    virtual int substeps_per_step() const = 0;
};

// Who solves the equations of motion, with the same model and the same contact parameters.
// reference: Bullet's multibody world (reference/). fast: our own time stepper on the finger dynamics that Bullet's
// multibody gives (fast/), for the welded hand.
enum class Stepper { reference, fast };

// "reference", "fast"; in the order of the enumeration.
const std::vector<std::string> &stepper_names();

// Throws std::out_of_range for a name that is none.
Stepper stepper_of_name(const std::string &name);

// Throws std::runtime_error with one sentence if the straight hand touches the object (it names link, object and
// depth), and NotCovered if the stepper does not cover this hand or set-up.
std::unique_ptr<World> make_world(Stepper stepper, const HandModel &hand, const ObjectSpec &object,
                                  const settings::Setup &setup, HandHold hold);

} // namespace twiddle::sim
