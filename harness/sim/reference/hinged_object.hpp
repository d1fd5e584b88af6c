// hinged_object.hpp: the object on its hinge, a one-joint Bullet multibody with friction in the joint.
#pragma once

#include "settings/setup.hpp"
#include "sim/object_body.hpp"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <memory>

namespace twiddle::sim
{

class HingedObject
{
  public:
    // The hinge runs through the centre along the palm's z axis.
    HingedObject(const ObjectBody &body, const settings::ObjectSetup &setup, double substep_s);

    btMultiBody &body()
    {
        return *body_;
    }
    btMultiBodyLinkCollider &collider()
    {
        return *collider_;
    }
    btMultiBodyJointMotor &coulomb_friction()
    {
        return *coulomb_friction_;
    }

    // Rotation about the palm's +z, counter-clockwise positive, not wrapped.
    double angle_rad() const;
    double velocity_rad_s() const;

    // The viscous part of the hinge's friction, for the coming substep.
    void apply_viscous_friction();

    // Angle and velocity 0.
    void reset();

  private:
    double viscous_nms_per_rad_;
    std::unique_ptr<btCollisionShape> shape_;
    std::unique_ptr<btMultiBody> body_;
    std::unique_ptr<btMultiBodyLinkCollider> collider_;
    std::unique_ptr<btMultiBodyJointMotor> coulomb_friction_;
    btAlignedObjectArray<btQuaternion> scratch_rotation_;
    btAlignedObjectArray<btVector3> scratch_vector_;
};

} // namespace twiddle::sim
