#include "hinge_friction.hpp"

#include <cmath>

namespace twiddle::sim
{

HingeFriction::HingeFriction(double coulomb_nm, double inertia_kg_m2, double substep_s)
    : largest_change_(coulomb_nm * substep_s / std::sqrt(inertia_kg_m2))
{
}

double HingeFriction::start(HingeRegime regime, double free) const
{
    switch (regime) {
    case HingeRegime::turning_forward:
        return free - largest_change_;
    case HingeRegime::turning_backward:
        return free + largest_change_;
    case HingeRegime::held:
        break;
    }
    return 0;
}

HingeRegime HingeFriction::judge(HingeRegime regime, double wanted, double found) const
{
    switch (regime) {
    case HingeRegime::turning_forward:
        return found < 0 ? HingeRegime::held : regime;
    case HingeRegime::turning_backward:
        return found > 0 ? HingeRegime::held : regime;
    case HingeRegime::held:
        if (wanted > largest_change_) return HingeRegime::turning_forward;
        if (wanted < -largest_change_) return HingeRegime::turning_backward;
        break;
    }
    return HingeRegime::held;
}

} // namespace twiddle::sim
