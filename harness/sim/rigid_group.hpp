// rigid_group.hpp: mass, centre of mass and principal inertia of rigidly joined links.
#pragma once

#include "hand_model.hpp"

namespace twiddle::sim
{

// Links joined so far, in the frame of the first.
class RigidGroup
{
  public:
    // Join `link` at X_group_link. Its joint's drive adds `reflected_inertia_kg_m2` about the joint's
    // axis, the link's z.
    void add(const HandLink &link, const btTransform &X_group_link, double reflected_inertia_kg_m2);

    double mass_kg() const
    {
        return mass_kg_;
    }
    // The principal frame at the centre of mass, and the moments along its axes.
    btTransform X_group_principal(btVector3 &moments_kg_m2) const;

  private:
    double mass_kg_ = 0;
    btVector3 first_moment_kg_m_{0, 0, 0};
    btMatrix3x3 inertia_kg_m2_{0, 0, 0, 0, 0, 0, 0, 0, 0}; // about the group's origin
};

} // namespace twiddle::sim
