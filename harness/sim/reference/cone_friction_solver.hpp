// cone_friction_solver.hpp: block Gauss-Seidel on the rows that Bullet's multibody solver sets up, with Coulomb's cone.
//
// Bullet 3.24 solves the two friction rows of a contact with two different effective masses and then clips their pair
// to the friction disk: its fixed point does not oppose the slip. It also treats normal and friction one row at a time,
// which converges slowly where a finger of two joints couples them. Here each contact is solved exactly, as a block of
// three (coulomb_contact.hpp), and the sweeps only have to settle contacts, stops and hinge friction among each other.
// Setting up the rows stays Bullet's.
#pragma once

#include "sim/coulomb_contact.hpp"

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

#include <vector>

namespace twiddle::sim
{

// For worlds of fixed-base multibodies only: rigid bodies, torsional and spinning friction are not solved.
class ConeFrictionSolver : public btMultiBodyConstraintSolver
{
  protected:
    // One sweep over joint constraints and contacts; returns the largest squared velocity change.
    btScalar solveSingleIteration(int iteration, btCollisionObject **bodies, int body_count,
                                  btPersistentManifold **manifolds, int manifold_count, btTypedConstraint **constraints,
                                  int constraint_count, const btContactSolverInfo &info,
                                  btIDebugDraw *debug_drawer) override;

    // Hands the velocity changes of all sweeps to the multibodies, once.
    btScalar solveGroupCacheFriendlyFinish(btCollisionObject **bodies, int body_count,
                                           const btContactSolverInfo &info) override;

  private:
    // The normal row of contact `index` and its two friction rows.
    std::array<btMultiBodySolverConstraint *, 3> contact_rows(int index);
    void prepare_contacts();

    // Velocity along the row that the impulses so far have caused.
    btScalar velocity_change(const btMultiBodySolverConstraint &row) const;
    void apply(const btMultiBodySolverConstraint &row, btScalar impulse);
    // Each returns the velocity change that it made.
    btScalar solve_row(btMultiBodySolverConstraint &row);
    btScalar solve_contact(int index);

    struct SolvedContact {
        ContactMatrix inverse_mass{};
        CoulombContact law;
    };
    std::vector<SolvedContact> contacts_; // [normal rows]
};

} // namespace twiddle::sim
