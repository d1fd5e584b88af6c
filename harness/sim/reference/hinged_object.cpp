#include "hinged_object.hpp"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

namespace twiddle::sim
{

namespace
{

// Bullet's margin lies within the outer dimensions of box and cylinder and rounds their edges.
std::unique_ptr<btCollisionShape> make_shape(const ObjectBody &body)
{
    if (body.shape == Shape::sphere) return std::make_unique<btSphereShape>(body.radius_m);
    std::unique_ptr<btConvexInternalShape> shape;
    if (body.shape == Shape::cylinder) {
        shape = std::make_unique<btCylinderShapeZ>(btVector3(body.radius_m, body.radius_m, body.height_m / 2));
    } else {
        shape = std::make_unique<btBoxShape>(btVector3(body.side_m, body.side_m, body.height_m) / 2);
    }
    shape->setMargin(body.rounding_m);
    return shape;
}

} // namespace

HingedObject::HingedObject(const ObjectBody &body, const settings::ObjectSetup &setup, double substep_s)
    : viscous_nms_per_rad_(setup.viscous_nms_per_rad), shape_(make_shape(body)),
      body_(std::make_unique<btMultiBody>(1, 0, btVector3(0, 0, 0), true, false))
{
    body_->setBasePos(body.p_palm_centre_m);
    body_->setWorldToBaseRot(btQuaternion::getIdentity());
    // Only the moment about the hinge acts; the same value on the other axes keeps the link's inertia a sphere's.
    const btVector3 moments(body.inertia_kg_m2, body.inertia_kg_m2, body.inertia_kg_m2);
    const btVector3 origin(0, 0, 0);
    body_->setupRevolute(0, setup.mass_kg, moments, -1, btQuaternion::getIdentity(), btVector3(0, 0, 1), origin, origin,
                         true);
    body_->finalizeMultiDof();
    body_->setLinearDamping(0);
    body_->setAngularDamping(0);
    body_->setMaxCoordinateVelocity(1e5);
    body_->setMaxAppliedImpulse(1e5);

    collider_ = std::make_unique<btMultiBodyLinkCollider>(body_.get(), 0);
    collider_->setCollisionShape(shape_.get());
    collider_->setActivationState(DISABLE_DEACTIVATION);
    body_->getLink(0).m_collider = collider_.get();

    coulomb_friction_ = std::make_unique<btMultiBodyJointMotor>(body_.get(), 0, 0.0, setup.coulomb_nm * substep_s);
    coulomb_friction_->finalizeMultiDof();
    reset();
}

double HingedObject::angle_rad() const
{
    return body_->getJointPos(0);
}

double HingedObject::velocity_rad_s() const
{
    return body_->getJointVel(0);
}

void HingedObject::apply_viscous_friction()
{
    body_->addJointTorque(0, -viscous_nms_per_rad_ * velocity_rad_s());
}

void HingedObject::reset()
{
    body_->clearForcesAndTorques();
    body_->clearVelocities();
    body_->setJointPos(0, 0);
    body_->setJointVel(0, 0);
    body_->forwardKinematics(scratch_rotation_, scratch_vector_);
    body_->updateCollisionObjectWorldTransforms(scratch_rotation_, scratch_vector_);
}

} // namespace twiddle::sim
