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
    const int velocity = 6 + m_bodyA->getLink(m_linkA).m_dofOffset; // Bullet's first six are the base's
    jacobianA(0)[velocity] = 1;
    jacobianA(1)[velocity] = -1;
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

void JointStop::createConstraintRows(btMultiBodyConstraintArray &rows, btMultiBodyJacobianData &data,
                                     const btContactSolverInfo &info)
{
    if (m_numDofsFinalized != m_jacSizeBoth) finalizeMultiDof();
    const double angle_rad = m_bodyA->getJointPos(m_linkA);
    const double velocity_rad_s = m_bodyA->getJointVel(m_linkA);
    const std::array<double, 2> distance_rad = {angle_rad - lower_rad_, upper_rad_ - angle_rad};
    const std::array<double, 2> approach_rad_s = {-velocity_rad_s, velocity_rad_s};
    const btVector3 unused(0, 0, 0);
    for (int side = 0; side < 2; side++) {
        // The solver cannot add more than this to the velocity in one substep without a stop in sight.
        const double reach_rad = 0.02 + approach_rad_s[side] * info.m_timeStep;
        if (distance_rad[side] > reach_rad) continue;
        const double share = distance_rad[side] > 0 ? 1 : error_reduction_;
        const double least_velocity_rad_s = -share * distance_rad[side] / info.m_timeStep;
        btMultiBodySolverConstraint &row = rows.expandNonInitializing();
        row.m_orgConstraint = this;
        row.m_orgDofIndex = side;
        fillMultiBodyConstraint(row, data, jacobianA(side), jacobianB(side), unused, unused, unused, unused, 0, info, 0,
                                m_maxAppliedImpulse, false, 1, false, least_velocity_rad_s);
    }
}

} // namespace twiddle::sim
