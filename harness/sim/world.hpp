// world.hpp: one Bullet world with a hand and a hinged object, stepped by torques.
//
// The world is in the palm frame (hand_model.hpp). It knows nothing of CPGs, trials or rewards. A world that was reset
// continues exactly as a new one does.
#pragma once

#include "articulated_hand.hpp"
#include "hand_model.hpp"
#include "joints.hpp"
#include "object.hpp"
#include "setup.hpp"

#include <memory>

namespace twiddle::sim
{

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
    // Throws std::runtime_error if the straight hand touches the object (the sentence names link, object and depth).
    World(const HandModel &hand, const ObjectSpec &object, const Setup &setup, HandHold hold);
    ~World();
    World(World &&) noexcept;
    World &operator=(World &&) noexcept;

    // Back to the start: all joints at 0 (held ones at their angles), everything at rest.
    void reset();

    // Advance by one substep of 10 ms / substeps under the torques `torque_nm` (limited to the set-up's torque limit).
    void substep(const JointVector &torque_nm);

    // The controlled joints; cheap, for the PD law at every substep.
    JointVector angles_rad() const;
    JointVector velocities_rad_s() const;

    // The object's rotation, in the counted direction.
    double object_rotation_rad() const;

    // Everything; call it once a control step.
    Observation observe() const;

    int substeps_per_step() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace twiddle::sim
