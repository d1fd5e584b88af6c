// The controller's generated tables: current, and right.
#include "csv_frames.hpp"

#include "engine/export/hand_tables.hpp"
#include "settings/text_file.hpp"

#include <twiddle/convert.h>
#include <twiddle/icub_right_hand.h>

#include <gtest/gtest.h>

#include <type_traits>

namespace twiddle
{
namespace
{

// Half a step of a fixed-point number.
constexpr double half_step = std::is_floating_point_v<twd_num> ? 0 : 1.9e-9;

// Expected: the committed file, byte for byte. If this fails, run `make hand-tables`.
TEST(hand_tables, current)
{
    const auto hand = sim::read_hand_model(std::string(TWIDDLE_MODELS) + "/icub_right_hand.urdf");
    EXPECT_EQ(engine::hand_tables(hand), settings::read_text_file(TWIDDLE_HAND_TABLES));
}

void expect_chain(const twd_chain &chain, const std::string &finger)
{
    const auto frames = test::read_frames();
    ASSERT_EQ(chain.joints, 4);
    for (int i = 0; i < 4; ++i) {
        const auto &frame = test::frame_of(frames, finger + "_" + std::to_string(i));
        const auto &next = test::frame_of(frames, finger + (i == 3 ? "_tip" : "_" + std::to_string(i + 1)));
        const test::Matrix4 expected = test::transform(frame.xyz_m, frame.rpy_rad);
        for (int row = 0; row < 3; ++row) {
            EXPECT_NEAR(twd_num_to_double(chain.joint[i].origin_m[row]), expected[row][3], half_step + 2.7e-17)
                << frame.joint;
            for (int column = 0; column < 3; ++column) {
                EXPECT_NEAR(twd_num_to_double(chain.joint[i].rotation[row][column]), expected[row][column],
                            half_step + 1e-15)
                    << frame.joint;
            }
        }
        EXPECT_NEAR(twd_num_to_double(chain.joint[i].centre_of_mass_m[0]), next.xyz_m[0] / 2, half_step + 1e-15);
        EXPECT_EQ(chain.joint[i].centre_of_mass_m[1], TWD_NUM(0));
        EXPECT_EQ(chain.joint[i].centre_of_mass_m[2], TWD_NUM(0));
        // A capsule of radius 6.5 mm at 1500 kg/m3.
        const double mass_kg = 1500 * M_PI * 0.0065 * 0.0065 * (next.xyz_m[0] + 4.0 / 3 * 0.0065);
        EXPECT_NEAR(twd_num_to_double(chain.joint[i].mass_kg), mass_kg, half_step + 1e-11) << frame.joint;
    }
}

// Expected: the public model's frames (data/icub_right_hand.csv) and the capsules' closed-form masses.
TEST(hand_tables, chains_equal_the_listed_frames)
{
    expect_chain(twd_icub_index, "index");
    expect_chain(twd_icub_thumb, "thumb");
}

// Expected: Ciancio et al. 2011 (0..90, -15..15, 0..90, 0..130 deg); the public model rounds 90 deg to 1.5707963 rad.
TEST(hand_tables, ranges_are_the_papers)
{
    constexpr double deg = M_PI / 180;
    constexpr double expected[TWD_ICUB_JOINTS][2] = {
        {0, 90 * deg}, {-15 * deg, 15 * deg}, {0, 90 * deg}, {0, 130 * deg}};
    for (int joint = 0; joint < TWD_ICUB_JOINTS; ++joint) {
        EXPECT_NEAR(twd_num_to_double(twd_icub_joint_range[joint].lower_rad), expected[joint][0], 1e-7);
        EXPECT_NEAR(twd_num_to_double(twd_icub_joint_range[joint].upper_rad), expected[joint][1], 1e-7);
    }
}

} // namespace
} // namespace twiddle
