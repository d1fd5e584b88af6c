// joint_stop.hpp: the range of a revolute joint as two unilateral constraints in Bullet's multibody solver.
//
// Bullet's own joint limit acts only once the stop is passed. This one acts a substep ahead, as contacts do: a joint
// may approach its stop no faster than reaches it exactly.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

namespace twiddle::sim
{

class JointStop : public btMultiBodyConstraint
{
  public:
    // `link` is a revolute link of `body`; the range is in rad.
    JointStop(btMultiBody &body, int link, double lower_rad, double upper_rad, double error_reduction);

    void finalizeMultiDof() override;
    int getIslandIdA() const override;
    int getIslandIdB() const override;
    void createConstraintRows(btMultiBodyConstraintArray &rows, btMultiBodyJacobianData &data,
                              const btContactSolverInfo &info) override;
    void debugDraw(btIDebugDraw *) override
    {
    }

  private:
    // Add the row of one stop (0: lower, 1: upper), which asks for at least this change of the velocity away from it.
    void add_row(btMultiBodyConstraintArray &rows, btMultiBodyJacobianData &data, int side,
                 double wanted_change_rad_s) const;

    double lower_rad_;
    double upper_rad_;
    double error_reduction_;
};

} // namespace twiddle::sim
