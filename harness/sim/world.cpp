#include "world.hpp"

#include "fast/fast_world.hpp"
#include "reference/reference_world.hpp"

#include <algorithm>
#include <stdexcept>

namespace twiddle::sim
{

btVector3 gravity_palm_m_s2(const HandModel &hand, const settings::PhysicsSetup &setup)
{
    const auto &d = setup.gravity_direction;
    const btVector3 direction_hand(d[0], d[1], d[2]);
    return hand.X_hand_palm.getBasis().transpose() * direction_hand * setup.gravity_m_s2;
}

const std::vector<std::string> &stepper_names()
{
    static const std::vector<std::string> names = {"reference", "fast"};
    return names;
}

Stepper stepper_of_name(const std::string &name)
{
    const auto &names = stepper_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::out_of_range("there is no stepper '" + name + "'");
    return static_cast<Stepper>(found - names.begin());
}

std::unique_ptr<World> make_world(Stepper stepper, const HandModel &hand, const ObjectSpec &object,
                                  const settings::Setup &setup, HandHold hold)
{
    if (stepper == Stepper::fast) return make_fast_world(hand, object, setup, hold);
    return make_reference_world(hand, object, setup, hold);
}

} // namespace twiddle::sim
