// What the fast stepper does not cover is refused, in a sentence that names the stepper that does.
#include "../../scratch_folder.hpp"
#include "../fixtures.hpp"

#include "sim/object.hpp"
#include "sim/world.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace twiddle::sim
{
namespace
{

ObjectSpec small_sphere()
{
    return read_object(TWIDDLE_MODELS, "small-sphere");
}

// What make_world refuses as not covered; empty if it makes a world.
std::string refusal(Stepper stepper, const HandModel &hand, const settings::Setup &setup, HandHold hold)
{
    try {
        make_world(stepper, hand, small_sphere(), setup, hold);
    } catch (const NotCovered &refused) {
        return refused.what();
    }
    return "";
}

bool names_the_reference(const std::string &sentence, const std::string &reason)
{
    return test::is_one_sentence_with(sentence, {reason, "--stepper reference"});
}

// The iCub's hand with one passage of its URDF replaced; the passage stands there once.
HandModel changed_hand(const std::string &from, const std::string &to)
{
    std::ostringstream text;
    text << std::ifstream(std::string(TWIDDLE_MODELS) + "/icub_right_hand.urdf").rdbuf();
    std::string urdf = text.str();
    const std::size_t place = urdf.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    EXPECT_EQ(urdf.find(from, place + 1), std::string::npos) << from;
    urdf.replace(place, from.size(), to);
    const test::ScratchFolder folder;
    return read_hand_model(folder.write("hand.urdf", urdf));
}

TEST(fast_stepper_coverage, welded_hand_without_contact_between_fingers_is_covered)
{
    EXPECT_EQ(refusal(Stepper::fast, icub_hand(), default_setup(), HandHold::welded), "");
}

TEST(fast_stepper_coverage, full_hand_is_refused_and_the_reference_takes_it)
{
    const std::string sentence = refusal(Stepper::fast, icub_hand(), default_setup(), HandHold::full);
    EXPECT_TRUE(names_the_reference(sentence, "--hand full")) << sentence;
    EXPECT_EQ(refusal(Stepper::reference, icub_hand(), default_setup(), HandHold::full), "");
}

TEST(fast_stepper_coverage, contact_between_fingers_is_refused_and_the_reference_takes_it)
{
    const settings::Setup setup = default_setup({{"contact.index_thumb_contact", "true"}});
    const std::string sentence = refusal(Stepper::fast, icub_hand(), setup, HandHold::welded);
    EXPECT_TRUE(names_the_reference(sentence, "index_thumb_contact")) << sentence;
    EXPECT_EQ(refusal(Stepper::reference, icub_hand(), setup, HandHold::welded), "");
}

// A hand whose index finger's second joint hangs on the palm, beside the first: no finger of two joints in a row.
TEST(fast_stepper_coverage, hand_with_another_joint_tree_is_refused)
{
    const HandModel hand = changed_hand("<parent link=\"hand_index_0\"/>", "<parent link=\"hand\"/>");
    const std::string sentence = refusal(Stepper::fast, hand, default_setup(), HandHold::welded);
    EXPECT_TRUE(names_the_reference(sentence, "index_1")) << sentence;
}

// The same for the thumb.
TEST(fast_stepper_coverage, hand_with_another_thumb_is_refused)
{
    const HandModel hand = changed_hand("<parent link=\"hand_thumb_0\"/>", "<parent link=\"hand\"/>");
    const std::string sentence = refusal(Stepper::fast, hand, default_setup(), HandHold::welded);
    EXPECT_TRUE(names_the_reference(sentence, "thumb_1")) << sentence;
}

} // namespace
} // namespace twiddle::sim
