#include "rigid_group.hpp"

namespace twiddle::sim
{

namespace
{

// Inertia about the origin of a point mass at `p_m`.
btMatrix3x3 point_inertia(double mass_kg, const btVector3 &p_m)
{
    const double x = p_m.x(), y = p_m.y(), z = p_m.z();
    return btMatrix3x3(y * y + z * z, -x * y, -x * z, -x * y, x * x + z * z, -y * z, -x * z, -y * z, x * x + y * y) *
           mass_kg;
}

} // namespace

void RigidGroup::add(const HandLink &link, const btTransform &X_group_link, double reflected_inertia_kg_m2)
{
    btMatrix3x3 inertia_link = link.inertia_kg_m2;
    inertia_link[2][2] += reflected_inertia_kg_m2;
    const btMatrix3x3 &R = X_group_link.getBasis();
    const btVector3 p_group_com_m = X_group_link * link.p_link_com_m;
    mass_kg_ += link.mass_kg;
    first_moment_kg_m_ += link.mass_kg * p_group_com_m;
    inertia_kg_m2_ += R * inertia_link * R.transpose() + point_inertia(link.mass_kg, p_group_com_m);
}

btTransform RigidGroup::X_group_principal(btVector3 &moments_kg_m2) const
{
    const btVector3 p_group_com_m = first_moment_kg_m_ / mass_kg_;
    btMatrix3x3 inertia = inertia_kg_m2_ - point_inertia(mass_kg_, p_group_com_m);
    btMatrix3x3 rotation = btMatrix3x3::getIdentity();
    inertia.diagonalize(rotation, 1e-14, 50);
    moments_kg_m2.setValue(inertia[0][0], inertia[1][1], inertia[2][2]);
    return btTransform(rotation, p_group_com_m);
}

} // namespace twiddle::sim
