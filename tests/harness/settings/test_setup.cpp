// Set-ups: their files, overrides and the sentences that refuse wrong ones.
#include "scratch_folder.hpp"

#include "settings/joints.hpp"
#include "settings/setting_table.hpp"
#include "settings/text_file.hpp"
#include "setups.hpp"
#include "sim/hand_model.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <type_traits>

namespace twiddle
{
namespace
{

// What is known of each set-up; the lengths in m, angles in deg, torques in N m, masses in kg.
struct Expected {
    const char *name;
    double x, y, z, index_deg, thumb_deg, friction, coulomb, viscous, mass, lower_hz, upper_hz, lone_hz, pd_rad_s;
    int direction;
    double cylinder_height;
};

void PrintTo(const Expected &setup, std::ostream *stream)
{
    *stream << setup.name;
}

class NamedSetup : public testing::TestWithParam<Expected>
{
};

// Expected: the values found by search, written here a second time; gains go with (w / 60)^2 and w / 60.
TEST_P(NamedSetup, has_its_values)
{
    const Expected &e = GetParam();
    const settings::Setup s = test::load_setup(e.name);
    EXPECT_EQ(s.name, e.name);
    EXPECT_EQ(s.object.hinge_x_m, e.x);
    EXPECT_EQ(s.object.hinge_y_m, e.y);
    EXPECT_EQ(s.object.centre_z_m, e.z);
    EXPECT_EQ(s.object.mass_kg, e.mass);
    EXPECT_EQ(s.object.coulomb_nm, e.coulomb);
    EXPECT_EQ(s.object.viscous_nms_per_rad, e.viscous);
    EXPECT_EQ(s.object.counted_direction, e.direction);
    EXPECT_EQ(s.object.cylinder_height_m, e.cylinder_height);
    EXPECT_EQ(s.hand.index_distal_deg, e.index_deg);
    EXPECT_EQ(s.hand.thumb_distal_deg, e.thumb_deg);
    EXPECT_EQ(s.physics.friction, e.friction);
    EXPECT_EQ(s.oscillators.frequency_lower_hz, e.lower_hz);
    EXPECT_EQ(s.oscillators.frequency_upper_hz, e.upper_hz);
    EXPECT_EQ(s.oscillators.lone_frequency_hz, e.lone_hz);
    const double ratio = e.pd_rad_s / 60;
    const JointVector stiffness = {0.21, 0.32, 0.21, 0.37};
    const JointVector damping = {0.0069, 0.0107, 0.0069, 0.0122};
    for (std::size_t joint = 0; joint < joint_count; ++joint) {
        EXPECT_NEAR(s.hand.stiffness_nm_per_rad[joint], stiffness[joint] * ratio * ratio, 1e-9);
        EXPECT_NEAR(s.hand.damping_nms_per_rad[joint], damping[joint] * ratio, 1e-9);
    }
}

// A set-up's name without what a test's name may not hold.
std::string test_name(const testing::TestParamInfo<Expected> &setup)
{
    std::string name = setup.param.name;
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    return name;
}

INSTANTIATE_TEST_SUITE_P(
    setup, NamedSetup,
    testing::Values(Expected{"near", .050, -.030, .045, 20, 0, .8, .005, .001, .10, .5, 2, 1.25, 60, 1, .04},
                    Expected{"mid-a", .040, .001, .054, 0, 0, .5, .002, .0003, .11, .3, 1, .84, 60, -1, .04},
                    Expected{"mid-b", .048, 0, .044, 20, 20, .49, .0027, .00004, .12, .3, 1.16, .94, 40, -1, .05}),
    test_name);

// Expected: gravity along the straight fingers, 15 deg off -x of `hand`; oscillators and learner as the paper has them.
TEST(setup, shared_settings_have_their_values)
{
    const settings::Setup s = test::load_setup("mid-a");
    EXPECT_NEAR(s.physics.gravity_direction[0], -std::cos(M_PI / 12), 1e-15);
    EXPECT_NEAR(s.physics.gravity_direction[2], std::sin(M_PI / 12), 1e-15);
    EXPECT_EQ(s.object.cube_size, settings::CubeSize::whole_diagonal);
    EXPECT_EQ(s.oscillators.phase_start, settings::PhaseStart::desired_lag);
    EXPECT_EQ(s.oscillators.centre_start, settings::CentreStart::hand);
    EXPECT_EQ(s.oscillators.return_lag, settings::ReturnLag::negated);
    EXPECT_EQ(s.oscillators.saturation, settings::Saturation::sum);
    EXPECT_EQ(s.learner.learned_value, settings::LearnedValue::clipped);
    EXPECT_EQ(s.learner.selector_noise, settings::SelectorNoise::as_experts);
    EXPECT_FALSE(s.physics.index_thumb_contact);
    EXPECT_EQ(s.hand.pd_law, settings::PdLaw::plain);
    EXPECT_EQ(s.learner.actor_rate, 0.1);
    EXPECT_EQ(s.learner.critic_rate, 0.1);
    EXPECT_EQ(s.learner.noise_start, 0.5);
    EXPECT_EQ(s.learner.noise_end, 0.05);
    EXPECT_EQ(s.learner.noise_decay_fraction, 0.6);
}

// Inertia of `first_link`, of the links that hang on it, at `angle_rad` of each link, and of a drive about
// its joint's axis.
double inertia_about_joint(const sim::HandModel &hand, int first_link, const std::vector<double> &angle_rad,
                           double reflected_kg_m2)
{
    double inertia_kg_m2 = reflected_kg_m2;
    std::vector<bool> carried(hand.links.size(), false);
    std::vector<btTransform> X_first_link(hand.links.size(), btTransform::getIdentity());
    for (std::size_t i = static_cast<std::size_t>(first_link); i < hand.links.size(); ++i) {
        const sim::HandLink &link = hand.links[i];
        const bool is_first = i == static_cast<std::size_t>(first_link);
        carried[i] = is_first || (link.parent >= 0 && carried[static_cast<std::size_t>(link.parent)]);
        if (!carried[i]) continue;
        if (!is_first) {
            const btTransform turn(btQuaternion(btVector3(0, 0, 1), angle_rad[i]));
            X_first_link[i] = X_first_link[static_cast<std::size_t>(link.parent)] * link.X_parent_joint * turn;
        }
        const btVector3 com_m = X_first_link[i] * link.p_link_com_m;
        const btVector3 axis = X_first_link[i].getBasis().transpose() * btVector3(0, 0, 1);
        inertia_kg_m2 +=
            axis.dot(link.inertia_kg_m2 * axis) + link.mass_kg * (com_m.x() * com_m.x() + com_m.y() * com_m.y());
    }
    return inertia_kg_m2;
}

// Expected: the inertia of the links beyond each joint about its axis, summed link by link over the URDF, with the four
// joints in the middle of their ranges, within a per cent.
TEST(setup, stable_pd_law_knows_the_hands_inertias)
{
    const settings::Setup s = test::load_setup("mid-a");
    const sim::HandModel hand = sim::read_hand_model(std::string(TWIDDLE_MODELS) + "/icub_right_hand.urdf");
    std::vector<double> angle_rad(hand.links.size(), 0);
    for (const char *joint : joint_urdf_names) {
        const auto link = static_cast<std::size_t>(hand.link_of_joint(joint));
        angle_rad[link] = (hand.links[link].lower_rad + hand.links[link].upper_rad) / 2;
    }
    for (std::size_t joint = 0; joint < joint_count; ++joint) {
        const double expected = inertia_about_joint(hand, hand.link_of_joint(joint_urdf_names[joint]), angle_rad,
                                                    s.hand.reflected_inertia_kg_m2);
        EXPECT_NEAR(s.hand.pd_inertia_kg_m2[joint], expected, 0.01 * expected) << joint_names[joint];
    }
}

TEST(setup, every_file_loads_and_common_is_no_setup)
{
    const auto names = settings::setup_names(TWIDDLE_SETUPS);
    EXPECT_GE(names.size(), 3u);
    for (const auto &name : names) {
        EXPECT_NE(name, "common");
        EXPECT_NO_THROW(test::load_setup(name)) << name;
    }
}

// The merged settings are all there is to a set-up: read back from JSON text they give the same settings.
TEST(setup, travels_through_json)
{
    const settings::Setup before = test::load_setup("mid-b", {{"object.mass_kg", "0.2"}});
    const settings::Setup after = settings::setup_from_settings(before.settings, "mid-b", "run.json");
    EXPECT_EQ(after.settings, before.settings);
    EXPECT_EQ(after.object.mass_kg, 0.2);
    EXPECT_EQ(after.object.cylinder_height_m, 0.05);
    EXPECT_EQ(after.hand.damping_nms_per_rad, before.hand.damping_nms_per_rad);
}

// Another value that a setting takes than `value`, which it has.
nlohmann::json other_value(const nlohmann::json &value)
{
    static const std::map<std::string, std::string> other_word = {{"whole-diagonal", "half-diagonal"},
                                                                  {"desired-lag", "zero"},
                                                                  {"plain", "stable"},
                                                                  {"hand", "target"},
                                                                  {"negated", "equal"},
                                                                  {"sum", "each"},
                                                                  {"clipped", "unclipped"},
                                                                  {"as-experts", "none"}};
    if (value.is_string()) return other_word.at(value.get<std::string>());
    if (value.is_boolean()) return !value.get<bool>();
    if (value.is_array()) return {0, 1, 0};
    if (value == -1) return 1;
    if (value.is_number_integer() && value.get<int>() > 1) return value.get<int>() + 1;
    if (value.is_number()) return value == 0 ? 0.25 : value.get<double>() / 2;
    auto joints = value;
    for (auto &joint : joints)
        joint = joint.get<double>() / 2;
    return joints;
}

// The bytes of a set-up's plain parts.
std::string bytes_of(const settings::Setup &setup)
{
    std::string bytes;
    const auto append = [&bytes](const auto &part) {
        static_assert(std::is_trivially_copyable_v<std::decay_t<decltype(part)>>);
        bytes.append(reinterpret_cast<const char *>(&part), sizeof part);
    };
    append(setup.object);
    append(setup.hand);
    append(setup.physics);
    append(setup.oscillators);
    append(setup.learner);
    return bytes;
}

// Expected: changing one setting changes bytes of the Setup that no other setting changes.
TEST(setup, every_setting_is_stored_in_a_place_of_its_own)
{
    settings::Setup setup = test::load_setup("mid-a");
    const std::string before = bytes_of(setup);
    std::set<std::size_t> taken;
    for (const auto &setting : settings::setting_table()) {
        const auto value = nlohmann::json::parse(setup.settings).at(setting.section).at(setting.key);
        ASSERT_TRUE(setting.store(other_value(value), setup)) << setting.key;
        const std::string after = bytes_of(setup);
        EXPECT_NE(after, before) << setting.key;
        for (std::size_t byte = 0; byte < before.size(); ++byte) {
            if (after[byte] == before[byte]) continue;
            EXPECT_TRUE(taken.insert(byte).second) << setting.key;
        }
        ASSERT_TRUE(setting.store(value, setup)) << setting.key;
        EXPECT_EQ(bytes_of(setup), before) << setting.key;
    }
}

TEST(setup, overrides_take_toml_values_and_bare_words)
{
    const settings::Setup s =
        test::load_setup("mid-a", {{"object.mass_kg", "0.2"},
                                   {"object.cube_size", "half-diagonal"},
                                   {"oscillators.phase_start", "\"zero\""},
                                   {"hand.pd_law", "stable"},
                                   {"contact.index_thumb_contact", "true"},
                                   {"physics.substeps", "7"},
                                   {"object.counted_direction", "+1"},
                                   {"hand.damping_nms_per_rad", "{ fei = 0.1, aai = 0.2, fet = 0.3, ot = 0.4 }"},
                                   {"physics.gravity_direction", "[0, 0, 1]"},
                                   {"object.mass_kg", "0.3"}});
    EXPECT_EQ(s.object.mass_kg, 0.3); // the last one counts
    EXPECT_EQ(s.object.cube_size, settings::CubeSize::half_diagonal);
    EXPECT_EQ(s.oscillators.phase_start, settings::PhaseStart::zero);
    EXPECT_EQ(s.hand.pd_law, settings::PdLaw::stable);
    EXPECT_TRUE(s.physics.index_thumb_contact);
    EXPECT_EQ(s.physics.substeps, 7);
    EXPECT_EQ(s.object.counted_direction, 1);
    EXPECT_EQ(s.hand.damping_nms_per_rad, (JointVector{0.1, 0.2, 0.3, 0.4}));
    EXPECT_EQ(s.physics.gravity_direction[2], 1);
}

TEST(setup, a_wrong_override_is_refused_in_one_sentence_that_names_it)
{
    struct Case {
        const char *name, *value, *reason;
    };
    const std::vector<Case> cases = {
        {"object.mass_kg", "heavy", "[object] mass_kg is \"heavy\"; expected a number above 0"},
        {"object.mass_kg", "0", "[object] mass_kg is 0"},
        {"object.mass_kg", "nan", "[object] mass_kg is nan"},
        {"object.mass_kg", "inf", "[object] mass_kg is inf"},
        {"object.mass_kg", "1e999", "[object] mass_kg"},
        {"object.mass_kg", "", "[object] mass_kg"},
        {"object.mass_kg", "1\nfriction = 2", "[object] mass_kg"},
        {"object.mass_kg", "1979-05-27", "[object] mass_kg is \"1979-05-27\""},
        {"object.weight_kg", "1", "no setting [object] weight_kg; expected one of hinge_x_m"},
        {"thing.mass_kg", "1", "no section [thing]; expected one of object, hand"},
        {"mass_kg", "1", "section.key=value"},
        {"physics.substeps", "5.5", "[physics] substeps is 5.5; expected a whole number"},
        {"physics.substeps", "99999999999", "[physics] substeps"},
        {"object.counted_direction", "0", "1 or -1"},
        {"object.cube_size", "diagonal", "\"whole-diagonal\" or \"half-diagonal\""},
        {"oscillators.centre_start", "one", "\"hand\" or \"zero\" or \"target\""},
        {"contact.index_thumb_contact", "1", "true or false"},
        {"hand.stiffness_nm_per_rad", "0.2", "{ fei, aai, fet, ot }"},
        {"hand.stiffness_nm_per_rad", "{ fei = 0.2, aai = 0.2, fet = 0.2 }", "{ fei, aai, fet, ot }"},
        {"hand.stiffness_nm_per_rad", "{ fei = 0.2, aai = 0.2, fet = 0.2, thumb = 1 }", "{ fei, aai, fet, ot }"},
        {"physics.gravity_direction", "[0, 0, 2]", "vector of length 1"},
        {"physics.gravity_direction", "[0, 1]", "vector of length 1"},
    };
    for (const auto &[name, value, reason] : cases) {
        const std::string error = test::error_of([&, n = name, v = value] { test::load_setup("mid-a", {{n, v}}); });
        EXPECT_TRUE(test::is_one_sentence_with(error, {"--set", reason})) << name << "=" << value << ": " << error;
    }
}

TEST(setup, settings_that_contradict_each_other_are_refused)
{
    for (const auto &[name, value] : std::vector<settings::Override>{{"oscillators.frequency_lower_hz", "4"},
                                                                     {"oscillators.centre_lower", "1"},
                                                                     {"learner.noise_end", "0.9"}}) {
        const std::string error = test::error_of([&, n = name, v = value] { test::load_setup("mid-a", {{n, v}}); });
        const std::string key = name.substr(name.find('.') + 1);
        EXPECT_TRUE(test::is_one_sentence_with(error, {"mid-a.toml with --set", key})) << error;
    }
}

// A set-up of one's own may be given as a path; faults name it and its setting.
TEST(setup, a_wrong_file_is_refused_in_one_sentence_that_names_it)
{
    const test::ScratchFolder folder;
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"[object]\nmass_kg = \"heavy\"\n", "own.toml: [object] mass_kg is \"heavy\""},
        {"[object]\nmass = 1\n", "own.toml: there is no setting [object] mass"},
        {"[objects]\nmass_kg = 1\n", "own.toml: there is no section [objects]"},
        {"[objects]\n", "own.toml: there is no section [objects]"},
        {"object = 1\n", "own.toml: \"object\" is no section"},
        {"[object]\n\nmass_kg = \n", "own.toml:3: this is no valid TOML"},
        {"[object]\nmass_kg = 1\nmass_kg = 2\n", "own.toml:3: this is no valid TOML"},
        {"[object\n", "own.toml:1: this is no valid TOML"},
    };
    for (const auto &[text, reason] : cases) {
        const auto path = folder.write("own.toml", text);
        const std::string error = test::error_of([&, p = path] { test::load_setup(p.string()); });
        EXPECT_TRUE(test::is_one_sentence_with(error, {reason})) << text << error;
    }
    const settings::Setup own = test::load_setup(folder.write("own.toml", "[object]\nmass_kg = 1\n").string());
    EXPECT_EQ(own.name, "own");
    EXPECT_EQ(own.object.mass_kg, 1);
}

TEST(setup, an_unknown_name_lists_the_known_ones)
{
    for (const char *name : {"far", "common", ""}) {
        const std::string error = test::error_of([&] { test::load_setup(name); });
        EXPECT_TRUE(test::is_one_sentence_with(error, {std::string("\"") + name + "\"", "mid-b, near, paper"}))
            << error;
    }
    const std::string error = test::error_of([] { test::load_setup("/nowhere/far.toml"); });
    EXPECT_TRUE(test::is_one_sentence_with(error, {"/nowhere/far.toml", "no such file"})) << error;
}

// run.json is checked as strictly as a file; expected: the named source and the missing or wrong setting.
TEST(setup, incomplete_settings_are_refused)
{
    const auto whole = test::load_setup("mid-a").settings;
    for (const auto &setting : settings::setting_table()) {
        auto settings = nlohmann::json::parse(whole);
        settings[setting.section].erase(setting.key);
        const std::string error =
            test::error_of([&] { settings::setup_from_settings(settings.dump(), "mid-a", "run.json"); });
        const std::string title = "[" + setting.section + "] " + setting.key;
        EXPECT_TRUE(test::is_one_sentence_with(error, {"run.json: " + title + " is missing; expected"})) << error;
    }
    const std::string error = test::error_of([] { settings::setup_from_settings("[]", "mid-a", "run.json"); });
    EXPECT_TRUE(test::is_one_sentence_with(error, {"run.json:", "no settings"})) << error;
}

// Each setting in common.toml, and no other, stands below a comment of its own or of its group.
TEST(setup, every_default_stands_below_a_comment)
{
    std::istringstream file(settings::read_text_file(TWIDDLE_SETUPS "/common.toml"));
    bool explained = false;
    std::size_t settings = 0;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '[') explained = false;
        if (line[0] == '#') explained = true;
        if (line.empty() || line[0] == '[' || line[0] == '#') continue;
        EXPECT_TRUE(explained) << line;
        ++settings;
    }
    EXPECT_EQ(settings, settings::setting_table().size());
}

} // namespace
} // namespace twiddle
