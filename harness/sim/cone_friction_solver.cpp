#include "cone_friction_solver.hpp"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <cmath>

namespace twiddle::sim
{

namespace
{

// Bullet's first six velocities are the base's, and every base here is fixed.
constexpr int base_velocities = 6;

// d = 1 / (1/d1 + 1/d2) for both rows keeps Gauss-Seidel stable. A row of effective mass 0 is switched off and stays so.
void share_effective_mass(btMultiBodySolverConstraint &first, btMultiBodySolverConstraint &second)
{
    const btScalar d1 = first.m_jacDiagABInv, d2 = second.m_jacDiagABInv;
    if (d1 <= 0 || d2 <= 0) return;
    const btScalar shared = 1 / (1 / d1 + 1 / d2);
    first.m_rhs *= shared / d1;
    second.m_rhs *= shared / d2;
    first.m_jacDiagABInv = shared;
    second.m_jacDiagABInv = shared;
}

} // namespace

btScalar ConeFrictionSolver::velocity_change(const btMultiBodySolverConstraint &row) const
{
    btScalar sum = 0;
    const btScalar *jacobian = &m_data.m_jacobians[row.m_jacAindex];
    const btScalar *change = &m_data.m_deltaVelocities[row.m_deltaVelAindex];
    const int count_a = base_velocities + row.m_multiBodyA->getNumDofs();
    for (int i = base_velocities; i < count_a; i++)
        sum += jacobian[i] * change[i];
    if (row.m_multiBodyB == row.m_multiBodyA && row.m_jacBindex == row.m_jacAindex) return sum;
    jacobian = &m_data.m_jacobians[row.m_jacBindex];
    change = &m_data.m_deltaVelocities[row.m_deltaVelBindex];
    const int count_b = base_velocities + row.m_multiBodyB->getNumDofs();
    for (int i = base_velocities; i < count_b; i++)
        sum += jacobian[i] * change[i];
    return sum;
}

void ConeFrictionSolver::apply(const btMultiBodySolverConstraint &row, btScalar impulse)
{
    const btScalar *unit = &m_data.m_deltaVelocitiesUnitImpulse[row.m_jacAindex];
    btScalar *change = &m_data.m_deltaVelocities[row.m_deltaVelAindex];
    const int count_a = base_velocities + row.m_multiBodyA->getNumDofs();
    for (int i = base_velocities; i < count_a; i++)
        change[i] += unit[i] * impulse;
    unit = &m_data.m_deltaVelocitiesUnitImpulse[row.m_jacBindex];
    change = &m_data.m_deltaVelocities[row.m_deltaVelBindex];
    const int count_b = base_velocities + row.m_multiBodyB->getNumDofs();
    for (int i = base_velocities; i < count_b; i++)
        change[i] += unit[i] * impulse;
}

btScalar ConeFrictionSolver::solve_row(btMultiBodySolverConstraint &row)
{
    if (row.m_jacDiagABInv <= 0) return 0;
    const btScalar before = row.m_appliedImpulse;
    const btScalar wanted = before + row.m_rhs - before * row.m_cfm - velocity_change(row) * row.m_jacDiagABInv;
    const btScalar after = std::clamp(wanted, row.m_lowerLimit, row.m_upperLimit);
    row.m_appliedImpulse = after;
    apply(row, after - before);
    return (after - before) / row.m_jacDiagABInv;
}

btScalar ConeFrictionSolver::solve_friction(btMultiBodySolverConstraint &first, btMultiBodySolverConstraint &second)
{
    if (first.m_jacDiagABInv <= 0 || second.m_jacDiagABInv <= 0) return 0;
    const btScalar limit =
        first.m_friction * m_multiBodyNormalContactConstraints[first.m_frictionIndex].m_appliedImpulse;
    const btScalar before1 = first.m_appliedImpulse, before2 = second.m_appliedImpulse;
    const btScalar wanted1 = before1 + first.m_rhs - velocity_change(first) * first.m_jacDiagABInv;
    const btScalar wanted2 = before2 + second.m_rhs - velocity_change(second) * second.m_jacDiagABInv;
    const btScalar wanted = std::sqrt(wanted1 * wanted1 + wanted2 * wanted2);
    const btScalar scale = wanted > limit ? limit / wanted : 1;
    first.m_appliedImpulse = scale * wanted1;
    second.m_appliedImpulse = scale * wanted2;
    const btScalar change1 = first.m_appliedImpulse - before1, change2 = second.m_appliedImpulse - before2;
    apply(first, change1);
    apply(second, change2);
    return std::sqrt(change1 * change1 + change2 * change2) / first.m_jacDiagABInv;
}

btScalar ConeFrictionSolver::solveSingleIteration(int iteration, btCollisionObject **, int, btPersistentManifold **,
                                                  int, btTypedConstraint **, int, const btContactSolverInfo &,
                                                  btIDebugDraw *)
{
    auto &friction = m_multiBodyFrictionContactConstraints;
    if (iteration == 0) {
        for (int i = 0; i + 1 < friction.size(); i += 2)
            share_effective_mass(friction[i], friction[i + 1]);
    }
    btScalar residual = 0;
    const auto keep_largest = [&residual](btScalar change) { residual = std::max(residual, change * change); };
    for (int i = 0; i < m_multiBodyNonContactConstraints.size(); i++) {
        keep_largest(solve_row(m_multiBodyNonContactConstraints[i]));
    }
    for (int i = 0; i < m_multiBodyNormalContactConstraints.size(); i++) {
        keep_largest(solve_row(m_multiBodyNormalContactConstraints[i]));
    }
    for (int i = 0; i + 1 < friction.size(); i += 2)
        keep_largest(solve_friction(friction[i], friction[i + 1]));
    return residual;
}

btScalar ConeFrictionSolver::solveGroupCacheFriendlyFinish(btCollisionObject **bodies, int body_count,
                                                           const btContactSolverInfo &info)
{
    for (int i = 0; i < body_count; i++) {
        btMultiBodyLinkCollider *collider = btMultiBodyLinkCollider::upcast(bodies[i]);
        if (!collider || collider->m_multiBody->getCompanionId() < 0) continue;
        btMultiBody &body = *collider->m_multiBody;
        body.applyDeltaVeeMultiDof2(&m_data.m_deltaVelocities[body.getCompanionId()], 1);
        body.setCompanionId(-1); // a multibody has one collider a link; the others must not add the change again
    }
    return btMultiBodyConstraintSolver::solveGroupCacheFriendlyFinish(bodies, body_count, info);
}

} // namespace twiddle::sim
