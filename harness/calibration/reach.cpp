#include "reach.hpp"

#include "settings/constants.hpp"

#include "sim/clearance.hpp"
#include "sim/object_body.hpp"

#include <algorithm>

namespace twiddle::calibration
{

namespace
{

// From `first` to `last` in steps of `step`, the ends included where a step meets them.
std::vector<double> values_between(double first, double last, double step)
{
    std::vector<double> values;
    for (int i = 0; first + i * step <= last; ++i) {
        values.push_back(first + i * step);
    }
    return values;
}

bool holds(const std::pair<double, double> &window, double value)
{
    return value >= window.first && value <= window.second;
}

} // namespace

Reach::Reach(const sim::HandModel &hand, const settings::Setup &setup)
    : setup_(setup), hand_(hand, setup.hand, sim::HandHold::welded)
{
}

bool Reach::touches(sim::Finger finger, const sim::ObjectSpec &object, const JointVector &angle_rad)
{
    std::vector<double> posture;
    for (const sim::ArticulatedLink &link : hand_.links()) {
        if (!link.moves) continue;
        const auto joint = std::find(hand_.controlled().begin(), hand_.controlled().end(), link.body_link);
        posture.push_back(angle_rad[static_cast<std::size_t>(joint - hand_.controlled().begin())]);
    }
    hand_.set_posture(posture);
    const sim::ObjectBody body = sim::object_body(object, setup_.object);
    for (int link = 0; link < static_cast<int>(hand_.links().size()); ++link) {
        if (hand_.links()[static_cast<std::size_t>(link)].finger != finger) continue;
        const auto ends_m = hand_.p_palm_capsule_m(link);
        if (sim::capsule_overlap(body, 0, ends_m[0], ends_m[1], hand_.capsule(link).radius_m)) return true;
    }
    return false;
}

bool Reach::straight_hand_is_clear(const sim::ObjectSpec &object)
{
    return !touches(sim::Finger::index, object, {}) && !touches(sim::Finger::thumb, object, {});
}

std::optional<double> Reach::first_contact_deg(sim::Finger finger, const sim::ObjectSpec &object, JointVector angle_rad,
                                               Joint flexion, double last_deg)
{
    for (const double flexion_deg : values_between(0, last_deg, reach_step_deg)) {
        angle_rad[flexion] = flexion_deg * rad_per_deg;
        if (touches(finger, object, angle_rad)) return flexion_deg;
    }
    return std::nullopt;
}

std::optional<double> Reach::index_contact_deg(const sim::ObjectSpec &object, double aai_deg, double last_deg)
{
    JointVector angle_rad{};
    angle_rad[aai] = aai_deg * rad_per_deg;
    return first_contact_deg(sim::Finger::index, object, angle_rad, fei, last_deg);
}

std::optional<double> Reach::thumb_contact_deg(const sim::ObjectSpec &object, double ot_deg, double last_deg)
{
    JointVector angle_rad{};
    angle_rad[ot] = ot_deg * rad_per_deg;
    return first_contact_deg(sim::Finger::thumb, object, angle_rad, fet, last_deg);
}

bool Reach::index_fits(const sim::ObjectSpec &object, const ReachWindow &window)
{
    const auto [first_deg, last_deg] = window.index_aai_deg;
    for (const double aai_deg : values_between(first_deg, last_deg, abduction_step_deg)) {
        const std::optional<double> contact_deg = index_contact_deg(object, aai_deg, window.index_fei_deg.second);
        if (contact_deg && holds(window.index_fei_deg, *contact_deg)) return true;
    }
    return false;
}

bool Reach::thumb_fits(const sim::ObjectSpec &object, const ReachWindow &window)
{
    const auto [first_deg, last_deg] = window.thumb_ot_deg;
    for (const double ot_deg : values_between(first_deg, last_deg, opposition_step_deg)) {
        const std::optional<double> contact_deg = thumb_contact_deg(object, ot_deg, window.thumb_fet_deg.second);
        if (contact_deg && holds(window.thumb_fet_deg, *contact_deg)) return true;
    }
    return false;
}

bool Reach::fits(const std::vector<sim::ObjectSpec> &objects, const ReachWindow &window)
{
    const auto all = [&](auto &&holds_for) { return std::all_of(objects.begin(), objects.end(), holds_for); };
    // The cheap questions first: most set-ups of a wide search fail them.
    return all([&](const sim::ObjectSpec &object) { return straight_hand_is_clear(object); }) &&
           all([&](const sim::ObjectSpec &object) { return index_fits(object, window); }) &&
           all([&](const sim::ObjectSpec &object) { return thumb_fits(object, window); });
}

} // namespace twiddle::calibration
