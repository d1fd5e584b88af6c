// reach.hpp: where the fingers first touch an object, the geometry that a set-up must have before it is
// worth a training run.
#pragma once

#include "settings/setup.hpp"
#include "sim/articulated_hand.hpp"
#include "sim/hand_model.hpp"
#include "sim/object.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace twiddle::calibration
{

// Windows in deg, both ends included.
struct ReachWindow {
    std::pair<double, double> index_fei_deg; // FEI at the index's first contact ...
    std::pair<double, double> index_aai_deg; // ... for some AAI in here
    std::pair<double, double> thumb_fet_deg; // FET at the thumb's first contact ...
    std::pair<double, double> thumb_ot_deg;  // ... for some OT in here
};

// Looks at angles in steps of this size, deg.
constexpr double reach_step_deg = 1;
constexpr double abduction_step_deg = 5;
constexpr double opposition_step_deg = 10;

// The hand of one set-up beside one object, by libccd.
class Reach
{
  public:
    Reach(const sim::HandModel &hand, const settings::Setup &setup);

    // Whether no link of the straight hand touches the object.
    bool straight_hand_is_clear(const sim::ObjectSpec &object);

    // The first FEI at `aai_deg`, and the first FET at `ot_deg`, at which the finger touches, deg; nothing
    // up to `last_deg`.
    std::optional<double> index_contact_deg(const sim::ObjectSpec &object, double aai_deg, double last_deg);
    std::optional<double> thumb_contact_deg(const sim::ObjectSpec &object, double ot_deg, double last_deg);

    // Whether the straight hand is clear of all `objects` and both fingers meet each of them within the window.
    bool fits(const std::vector<sim::ObjectSpec> &objects, const ReachWindow &window);

  private:
    bool touches(sim::Finger finger, const sim::ObjectSpec &object, const JointVector &angle_rad);
    std::optional<double> first_contact_deg(sim::Finger finger, const sim::ObjectSpec &object, JointVector angle_rad,
                                            Joint flexion, double last_deg);
    bool index_fits(const sim::ObjectSpec &object, const ReachWindow &window);
    bool thumb_fits(const sim::ObjectSpec &object, const ReachWindow &window);

    settings::Setup setup_;
    sim::ArticulatedHand hand_;
};

} // namespace twiddle::calibration
