// hinge_friction.hpp: the Coulomb friction of the object's hinge.
//
// The hinge is in one of three regimes: held (velocity 0, the friction torque is whatever holds it, up to its limit),
// or turning either way against the full torque. In each the contacts are a problem of their own; the regime whose
// answer does not contradict it is the solution. As one more row of the contacts' sweeps the friction would be coupled
// to all of them and converge slowly.
#pragma once

namespace twiddle::sim
{

enum class HingeRegime { held, turning_forward, turning_backward };

class HingeFriction
{
  public:
    // `coulomb_nm` is the friction torque, `inertia_kg_m2` the object's about its hinge.
    HingeFriction(double coulomb_nm, double inertia_kg_m2, double substep_s);

    // The object's whitened velocity in `regime`, from the one without friction.
    double start(HingeRegime regime, double free) const;

    // The regime that the answer of `regime` speaks for; the same one if nothing contradicts. `wanted` is the whitened
    // velocity that the contacts' impulses would give the object without friction, `found` the one that it has.
    HingeRegime judge(HingeRegime regime, double wanted, double found) const;

  private:
    // Whitened velocity that the friction takes away in a substep at most.
    double largest_change_;
};

} // namespace twiddle::sim
