#include "setting_table.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>
#include <utility>

namespace twiddle::settings
{
namespace
{

using nlohmann::json;

// The values that a number may take, both ends included unless `open_lower`.
struct Range {
    double lower = 0;
    double upper = 0;
    bool open_lower = false;

    bool holds(double value) const
    {
        return (open_lower ? value > lower : value >= lower) && value <= upper;
    }
    std::string text() const
    {
        std::ostringstream text;
        text << (open_lower ? "above " : "from ") << lower << (open_lower ? " and at most " : " to ") << upper;
        return text.str();
    }
};

Range from(double lower, double upper)
{
    return {lower, upper, false};
}

Range above(double lower, double upper)
{
    return {lower, upper, true};
}

bool read_number(const json &value, const Range &range, double &number)
{
    if (!value.is_number()) return false;
    number = value.get<double>();
    return range.holds(number);
}

bool read_joints(const json &value, const Range &range, JointVector &joints)
{
    if (!value.is_object() || value.size() != joint_count) return false;
    for (std::size_t joint = 0; joint < joint_count; ++joint) {
        const auto found = value.find(joint_names[joint]);
        if (found == value.end() || !read_number(*found, range, joints[joint])) return false;
    }
    return true;
}

bool read_unit_vector(const json &value, std::array<double, 3> &vector)
{
    if (!value.is_array() || value.size() != vector.size()) return false;
    for (std::size_t axis = 0; axis < vector.size(); ++axis) {
        if (!read_number(value[axis], from(-1, 1), vector[axis])) return false;
    }
    return std::abs(std::hypot(vector[0], vector[1], vector[2]) - 1) <= 1e-6;
}

// The settings of one file section, which live in one member struct of Setup.
template <typename Part> struct Section {
    std::string name;
    Part Setup::*part;

    Setting number(const char *key, double Part::*member, const Range &range) const
    {
        return {name, key, "a number " + range.text(), [part = part, member, range](const json &value, Setup &setup) {
                    return read_number(value, range, setup.*part.*member);
                }};
    }
    Setting whole(const char *key, int Part::*member, const Range &range) const
    {
        return {name, key, "a whole number " + range.text(),
                [part = part, member, range](const json &value, Setup &setup) {
                    double number = 0;
                    if (!value.is_number_integer() || !read_number(value, range, number)) return false;
                    setup.*part.*member = static_cast<int>(number);
                    return true;
                }};
    }
    Setting sign(const char *key, int Part::*member) const
    {
        return {name, key, "1 or -1", [part = part, member](const json &value, Setup &setup) {
                    if (value != json(1) && value != json(-1)) return false;
                    setup.*part.*member = value == json(1) ? 1 : -1;
                    return true;
                }};
    }
    Setting flag(const char *key, bool Part::*member) const
    {
        return {name, key, "true or false", [part = part, member](const json &value, Setup &setup) {
                    if (!value.is_boolean()) return false;
                    setup.*part.*member = value.get<bool>();
                    return true;
                }};
    }
    // One of some words, each with its meaning.
    template <typename Choice>
    Setting word(const char *key, Choice Part::*member,
                 const std::vector<std::pair<std::string, Choice>> &choices) const
    {
        std::string expected;
        for (const auto &[word, meaning] : choices)
            expected += (expected.empty() ? "\"" : " or \"") + word + "\"";
        return {name, key, expected, [=, part = part](const json &value, Setup &setup) {
                    for (const auto &[word, meaning] : choices) {
                        if (value != json(word)) continue;
                        setup.*part.*member = meaning;
                        return true;
                    }
                    return false;
                }};
    }
    Setting joints(const char *key, JointVector Part::*member, const Range &range) const
    {
        return {name, key, "{ fei, aai, fet, ot }, each a number " + range.text(),
                [part = part, member, range](const json &value, Setup &setup) {
                    return read_joints(value, range, setup.*part.*member);
                }};
    }
    Setting unit_vector(const char *key, std::array<double, 3> Part::*member) const
    {
        return {name, key, "three numbers, a vector of length 1",
                [part = part, member](const json &value, Setup &setup) {
                    return read_unit_vector(value, setup.*part.*member);
                }};
    }
};

std::vector<Setting> make_table()
{
    using O = ObjectSetup;
    using H = HandSetup;
    using P = PhysicsSetup;
    using C = OscillatorSetup;
    using L = LearnerSetup;
    const Section<O> object{"object", &Setup::object};
    const Section<H> hand{"hand", &Setup::hand};
    const Section<P> contact{"contact", &Setup::physics};
    const Section<P> physics{"physics", &Setup::physics};
    const Section<C> oscillators{"oscillators", &Setup::oscillators};
    const Section<L> learner{"learner", &Setup::learner};
    return {
        object.number("hinge_x_m", &O::hinge_x_m, from(-0.2, 0.2)),
        object.number("hinge_y_m", &O::hinge_y_m, from(-0.2, 0.2)),
        object.number("centre_z_m", &O::centre_z_m, from(-0.2, 0.2)),
        object.number("mass_kg", &O::mass_kg, above(0, 10)),
        object.number("cylinder_height_m", &O::cylinder_height_m, above(0, 0.2)),
        object.word<CubeSize>(
            "cube_size", &O::cube_size,
            {{"whole-diagonal", CubeSize::whole_diagonal}, {"half-diagonal", CubeSize::half_diagonal}}),
        object.number("rounding_m", &O::rounding_m, above(0, 0.005)),
        object.number("coulomb_nm", &O::coulomb_nm, from(0, 1)),
        object.number("viscous_nms_per_rad", &O::viscous_nms_per_rad, from(0, 1)),
        object.sign("counted_direction", &O::counted_direction),

        hand.number("index_distal_deg", &H::index_distal_deg, from(0, 90)),
        hand.number("thumb_distal_deg", &H::thumb_distal_deg, from(0, 90)),
        // 20 deg is the range of the narrowest of their joints, ring_0 and little_0.
        hand.number("other_fingers_deg", &H::other_fingers_deg, from(0, 20)),
        hand.number("reflected_inertia_kg_m2", &H::reflected_inertia_kg_m2, from(0, 0.01)),
        hand.number("torque_limit_nm", &H::torque_limit_nm, above(0, 10)),
        hand.joints("stiffness_nm_per_rad", &H::stiffness_nm_per_rad, above(0, 10)),
        hand.joints("damping_nms_per_rad", &H::damping_nms_per_rad, from(0, 1)),
        hand.word<PdLaw>("pd_law", &H::pd_law, {{"plain", PdLaw::plain}, {"stable", PdLaw::stable}}),
        hand.joints("pd_inertia_kg_m2", &H::pd_inertia_kg_m2, above(0, 0.01)),

        contact.number("friction", &P::friction, from(0, 5)),
        contact.flag("index_thumb_contact", &P::index_thumb_contact),
        contact.number("breaking_threshold_m", &P::breaking_threshold_m, above(0, 0.1)),

        physics.whole("substeps", &P::substeps, from(1, 1000)),
        physics.whole("solver_iterations", &P::solver_iterations, from(1, 100000)),
        physics.number("solver_residual", &P::solver_residual, from(0, 1)),
        physics.number("error_reduction", &P::error_reduction, from(0, 1)),
        physics.number("gravity_m_s2", &P::gravity_m_s2, from(0, 20)),
        physics.unit_vector("gravity_direction", &P::gravity_direction),

        oscillators.number("frequency_lower_hz", &C::frequency_lower_hz, above(0, 5)),
        oscillators.number("frequency_upper_hz", &C::frequency_upper_hz, above(0, 5)),
        oscillators.number("lone_frequency_hz", &C::lone_frequency_hz, above(0, 5)),
        oscillators.number("amplitude_upper", &C::amplitude_upper, above(0, 0.5)),
        oscillators.number("centre_lower", &C::centre_lower, from(0, 1)),
        oscillators.number("centre_upper", &C::centre_upper, from(0, 1)),
        oscillators.number("amplitude_rate_per_s", &C::amplitude_rate_per_s, above(0, 1000)),
        oscillators.number("centre_rate_per_s", &C::centre_rate_per_s, above(0, 1000)),
        oscillators.word<PhaseStart>("phase_start", &C::phase_start,
                                     {{"desired-lag", PhaseStart::desired_lag}, {"zero", PhaseStart::zero}}),
        oscillators.word<CentreStart>(
            "centre_start", &C::centre_start,
            {{"hand", CentreStart::hand}, {"zero", CentreStart::zero}, {"target", CentreStart::target}}),
        oscillators.word<ReturnLag>("return_lag", &C::return_lag,
                                    {{"negated", ReturnLag::negated}, {"equal", ReturnLag::equal}}),
        oscillators.word<Saturation>("saturation", &C::saturation,
                                     {{"sum", Saturation::sum}, {"each", Saturation::each}}),

        learner.number("actor_rate", &L::actor_rate, from(0, 10)),
        learner.number("critic_rate", &L::critic_rate, from(0, 10)),
        learner.number("input_squared_norm", &L::input_squared_norm, above(0, 100)),
        learner.number("weight_range", &L::weight_range, from(0, 10)),
        learner.number("clip", &L::clip, from(0, 0.4)),
        learner.word<LearnedValue>("learned_value", &L::learned_value,
                                   {{"clipped", LearnedValue::clipped}, {"unclipped", LearnedValue::unclipped}}),
        learner.word<SelectorNoise>("selector_noise", &L::selector_noise,
                                    {{"as-experts", SelectorNoise::as_experts}, {"none", SelectorNoise::none}}),
        learner.number("noise_start", &L::noise_start, from(0, 1)),
        learner.number("noise_end", &L::noise_end, from(0, 1)),
        learner.number("noise_decay_fraction", &L::noise_decay_fraction, above(0, 1)),
        learner.number("reward_per_rad", &L::reward_per_rad, above(0, 100)),
    };
}

} // namespace

const std::vector<Setting> &setting_table()
{
    static const std::vector<Setting> table = make_table();
    return table;
}

} // namespace twiddle::settings
