// cone_friction_solver.hpp: projected Gauss-Seidel on the rows that Bullet's multibody solver sets up, with Coulomb's cone.
//
// Bullet 3.24 solves the two friction rows of a contact with two different effective masses and then clips their pair to the
// friction disk: the clipped fixed point does not oppose the slip. Here both rows share one effective
// mass and the pair is projected radially, so that the fixed point is Coulomb's law. Setting up the rows stays Bullet's.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

namespace twiddle::sim
{

// For worlds of fixed-base multibodies only: rigid bodies, torsional and spinning friction are not solved.
class ConeFrictionSolver : public btMultiBodyConstraintSolver
{
  protected:
    // One sweep over joint constraints, normal rows and friction pairs; returns the largest squared velocity change.
    btScalar solveSingleIteration(int iteration, btCollisionObject **bodies, int body_count,
                                  btPersistentManifold **manifolds, int manifold_count,
                                  btTypedConstraint **constraints, int constraint_count,
                                  const btContactSolverInfo &info, btIDebugDraw *debug_drawer) override;

    // Hands the velocity changes of all sweeps to the multibodies, once.
    btScalar solveGroupCacheFriendlyFinish(btCollisionObject **bodies, int body_count,
                                           const btContactSolverInfo &info) override;

  private:
    // Velocity along the row that the impulses so far have caused.
    btScalar velocity_change(const btMultiBodySolverConstraint &row) const;
    void apply(const btMultiBodySolverConstraint &row, btScalar impulse);
    // Each returns the velocity change that it made.
    btScalar solve_row(btMultiBodySolverConstraint &row);
    btScalar solve_friction(btMultiBodySolverConstraint &first, btMultiBodySolverConstraint &second);
};

} // namespace twiddle::sim
