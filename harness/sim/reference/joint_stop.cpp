#include "joint_stop.hpp"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <array>

namespace twiddle::sim
{

JointStop::JointStop(btMultiBody &body, int link, double lower_rad, double upper_rad, double error_reduction)
    : btMultiBodyConstraint(&body, &body, link, body.getLink(link).m_parent, 2, true, MULTIBODY_CONSTRAINT_LIMIT),
      lower_rad_(lower_rad), upper_rad_(upper_rad), error_reduction_(error_reduction)
{
    m_maxAppliedImpulse = 1e5;
}

void JointStop::finalizeMultiDof()
{
    allocateJacobiansMultiDof();
    m_numDofsFinalized = m_jacSizeBoth;
}

int JointStop::getIslandIdA() const
{
    return m_bodyA->getLink(m_linkA).m_collider->getIslandTag();
}

int JointStop::getIslandIdB() const
{
    return getIslandIdA();
}

// Bullet's own fillMultiBodyConstraint would compute the same body's response twice, once for each end of the joint.
void JointStop::add_row(btMultiBodyConstraintArray &rows, btMultiBodyJacobianData &data, int side,
                        double wanted_change_rad_s) const
{
    btMultiBodySolverConstraint &row = rows.expand();
    row.m_multiBodyA = m_bodyA;
    row.m_linkA = m_linkA;
    row.m_orgConstraint = const_cast<JointStop *>(this); // Bullet writes the impulse back into it
    row.m_orgDofIndex = side;
    row.m_contactNormal1.setZero();
    row.m_relpos1CrossNormal.setZero();

    const int count = 6 + m_bodyA->getNumDofs(); // Bullet's first six velocities are the base's
    if (m_bodyA->getCompanionId() < 0) {
        m_bodyA->setCompanionId(data.m_deltaVelocities.size());
        data.m_deltaVelocities.resize(data.m_deltaVelocities.size() + count);
    }
    row.m_deltaVelAindex = m_bodyA->getCompanionId();
    row.m_jacAindex = data.m_jacobians.size();
    data.m_jacobians.resize(row.m_jacAindex + count);
    data.m_deltaVelocitiesUnitImpulse.resize(row.m_jacAindex + count);
    btScalar *jacobian = &data.m_jacobians[row.m_jacAindex];
    btScalar *unit = &data.m_deltaVelocitiesUnitImpulse[row.m_jacAindex];
    const int velocity = 6 + m_bodyA->getLink(m_linkA).m_dofOffset;
    const double direction = side == 0 ? 1 : -1;
    jacobian[velocity] = direction;
    m_bodyA->calcAccelerationDeltasMultiDof(jacobian, unit, data.scratch_r, data.scratch_v);

    row.m_jacDiagABInv = 1 / (direction * unit[velocity]);
    row.m_rhs = wanted_change_rad_s * row.m_jacDiagABInv;
    row.m_rhsPenetration = 0;
    row.m_cfm = 0;
    row.m_friction = 0;
    row.m_appliedImpulse = 0;
    row.m_appliedPushImpulse = 0;
    row.m_lowerLimit = 0;
    row.m_upperLimit = m_maxAppliedImpulse;
}

void JointStop::createConstraintRows(btMultiBodyConstraintArray &rows, btMultiBodyJacobianData &data,
                                     const btContactSolverInfo &info)
{
    const double angle_rad = m_bodyA->getJointPos(m_linkA);
    const double velocity_rad_s = m_bodyA->getJointVel(m_linkA);
    const std::array<double, 2> distance_rad = {angle_rad - lower_rad_, upper_rad_ - angle_rad};
    const std::array<double, 2> leaving_rad_s = {velocity_rad_s, -velocity_rad_s};
    for (int side = 0; side < 2; side++) {
        // Contacts and holding motors may push the joint this much further in a substep than its velocity says. Wider
        // costs speed, a row for every stop; narrower lets a hard-driven joint jump past a stop that has no row yet.
        constexpr double reserve_rad = 0.3;
        if (distance_rad[side] + leaving_rad_s[side] * info.m_timeStep > reserve_rad) continue;
        const double share = distance_rad[side] > 0 ? 1 : error_reduction_;
        const double least_velocity_rad_s = -share * distance_rad[side] / info.m_timeStep;
        add_row(rows, data, side, least_velocity_rad_s - leaving_rad_s[side]);
    }
}

} // namespace twiddle::sim
