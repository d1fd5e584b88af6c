// contact_finder.hpp: the contacts of a finger with the object, as rows for the solver.
#pragma once

#include "constraint_search.hpp"
#include "contact_solver.hpp"
#include "finger_kinematics.hpp"
#include "segment_contacts.hpp"
#include "sim/object_body.hpp"

namespace twiddle::sim
{

// That one joint may carry.
constexpr int most_capsules = 8;

class ContactFinder
{
  public:
    // Contacts are made `breaking_threshold_m` before they touch; a penetration is corrected by the share
    // `error_reduction`.
    ContactFinder(const std::array<FingerKinematics, 2> &fingers, const ObjectBody &object, double breaking_threshold_m,
                  double error_reduction, double substep_s);

    // Fill `contacts` for fingers in `state` and the object turned by `object_rad`. A contact that the velocities
    // `free` (of the substep without contacts) carry far from touching is left out.
    void find(const std::array<FingerState, 2> &state, double object_rad, const Velocities &free,
              Contacts &contacts) const;

    // Whitened velocity of the object for an angular velocity of 1 rad/s: the square root of its inertia.
    double whitening() const
    {
        return whitening_;
    }

  private:
    // What one finger's contacts have in common.
    struct Scene;
    void find_of_joint(const Scene &scene, int joint, Contacts &contacts) const;
    void add_contact(const Scene &scene, int joint, const btVector3 &p_axis_m, const SegmentContact &place,
                     double radius_m, int feature, Contacts &contacts) const;

    std::array<FingerKinematics, 2> fingers_;
    RoundedCore core_;
    double whitening_;
    double inverse_whitening_;
    double breaking_threshold_m_;
    double error_reduction_;
    double substep_s_;
};

} // namespace twiddle::sim
