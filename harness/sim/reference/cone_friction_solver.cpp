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

int velocity_count(const btMultiBody *body)
{
    return base_velocities + body->getNumDofs();
}

// The velocity that a row asks for, relative to the one before the solve.
btScalar wanted_change(const btMultiBodySolverConstraint &row)
{
    return row.m_jacDiagABInv > 0 ? row.m_rhs / row.m_jacDiagABInv : 0;
}

} // namespace

btScalar ConeFrictionSolver::velocity_change(const btMultiBodySolverConstraint &row) const
{
    btScalar sum = 0;
    const btScalar *jacobian = &m_data.m_jacobians[row.m_jacAindex];
    const btScalar *change = &m_data.m_deltaVelocities[row.m_deltaVelAindex];
    for (int i = base_velocities; i < velocity_count(row.m_multiBodyA); i++)
        sum += jacobian[i] * change[i];
    if (!row.m_multiBodyB) return sum; // a joint stop
    jacobian = &m_data.m_jacobians[row.m_jacBindex];
    change = &m_data.m_deltaVelocities[row.m_deltaVelBindex];
    for (int i = base_velocities; i < velocity_count(row.m_multiBodyB); i++)
        sum += jacobian[i] * change[i];
    return sum;
}

void ConeFrictionSolver::apply(const btMultiBodySolverConstraint &row, btScalar impulse)
{
    const btScalar *unit = &m_data.m_deltaVelocitiesUnitImpulse[row.m_jacAindex];
    btScalar *change = &m_data.m_deltaVelocities[row.m_deltaVelAindex];
    for (int i = base_velocities; i < velocity_count(row.m_multiBodyA); i++)
        change[i] += unit[i] * impulse;
    if (!row.m_multiBodyB) return;
    unit = &m_data.m_deltaVelocitiesUnitImpulse[row.m_jacBindex];
    change = &m_data.m_deltaVelocities[row.m_deltaVelBindex];
    for (int i = base_velocities; i < velocity_count(row.m_multiBodyB); i++)
        change[i] += unit[i] * impulse;
}

std::array<btMultiBodySolverConstraint *, 3> ConeFrictionSolver::contact_rows(int index)
{
    btMultiBodySolverConstraint &normal = m_multiBodyNormalContactConstraints[index];
    auto &friction = m_multiBodyFrictionContactConstraints;
    return {&normal, &friction[normal.m_frictionIndex], &friction[normal.m_frictionIndex + 1]};
}

void ConeFrictionSolver::prepare_contacts()
{
    contacts_.clear();
    for (int index = 0; index < m_multiBodyNormalContactConstraints.size(); index++) {
        const auto rows = contact_rows(index);
        ContactMatrix inverse_mass{};
        for (int i = 0; i < 3; i++) {
            for (int j = i; j < 3; j++) {
                double sum = 0;
                const btScalar *jacobian = &m_data.m_jacobians[rows[i]->m_jacAindex];
                const btScalar *unit = &m_data.m_deltaVelocitiesUnitImpulse[rows[j]->m_jacAindex];
                for (int k = base_velocities; k < velocity_count(rows[i]->m_multiBodyA); k++)
                    sum += jacobian[k] * unit[k];
                jacobian = &m_data.m_jacobians[rows[i]->m_jacBindex];
                unit = &m_data.m_deltaVelocitiesUnitImpulse[rows[j]->m_jacBindex];
                for (int k = base_velocities; k < velocity_count(rows[i]->m_multiBodyB); k++)
                    sum += jacobian[k] * unit[k];
                inverse_mass[i][j] = inverse_mass[j][i] = sum;
            }
        }
        contacts_.push_back({inverse_mass, CoulombContact(inverse_mass, rows[1]->m_friction)});
    }
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

btScalar ConeFrictionSolver::solve_contact(int index)
{
    const SolvedContact &contact = contacts_[index];
    const ContactMatrix &w = contact.inverse_mass;
    const auto rows = contact_rows(index);
    if (w[0][0] <= 0) return 0;
    ContactVector before{}, b{};
    for (int i = 0; i < 3; i++)
        before[i] = rows[i]->m_appliedImpulse;
    for (int i = 0; i < 3; i++) {
        b[i] = velocity_change(*rows[i]) - wanted_change(*rows[i]);
        for (int j = 0; j < 3; j++)
            b[i] -= w[i][j] * before[j];
    }
    const ContactVector after = contact.law.solve(b);
    btScalar largest = 0;
    for (int i = 0; i < 3; i++) {
        rows[i]->m_appliedImpulse = after[i];
        if (after[i] != before[i]) apply(*rows[i], after[i] - before[i]);
        largest = std::max(largest, std::abs(after[i] - before[i]) * w[i][i]);
    }
    return largest;
}

btScalar ConeFrictionSolver::solveSingleIteration(int iteration, btCollisionObject **, int, btPersistentManifold **,
                                                  int, btTypedConstraint **, int, const btContactSolverInfo &,
                                                  btIDebugDraw *)
{
    if (iteration == 0) prepare_contacts();
    btScalar largest = 0;
    for (int i = 0; i < static_cast<int>(contacts_.size()); i++)
        largest = std::max(largest, solve_contact(i));
    for (int i = 0; i < m_multiBodyNonContactConstraints.size(); i++) {
        largest = std::max(largest, std::abs(solve_row(m_multiBodyNonContactConstraints[i])));
    }
    return largest * largest;
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
