// The straight hand's clearance of the object, and Bullet's contacts against libccd's Minkowski portal
// refinement (MPR).
#include "fixtures.hpp"

#include "sim/clearance.hpp"
#include "sim/object.hpp"
#include "sim/reference/hinged_object.hpp"
#include "sim/world.hpp"

#include "setups.hpp"
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace twiddle::sim
{
namespace
{

constexpr double deg = M_PI / 180;
constexpr double capsule_radius_m = 0.0065;

class StraightHand : public testing::TestWithParam<std::tuple<const char *, HandHold>>
{
};

// Expected: a world of every object in every set-up can be made (libccd finds no link in the object).
TEST_P(StraightHand, is_clear_of_all_nine_objects)
{
    const auto [setup, hold] = GetParam();
    const auto objects = object_names(TWIDDLE_MODELS);
    EXPECT_EQ(objects.size(), 9U);
    for (const auto &object : objects) {
        EXPECT_NO_THROW(make_world(Stepper::reference, icub_hand(), read_object(TWIDDLE_MODELS, object),
                                   test::load_setup(setup), hold))
            << object;
    }
}

INSTANTIATE_TEST_SUITE_P(Sim, StraightHand,
                         testing::Combine(testing::Values("near", "mid-a", "mid-b"),
                                          testing::Values(HandHold::welded, HandHold::full)),
                         [](const auto &world) {
                             std::string name = std::get<0>(world.param);
                             std::replace(name.begin(), name.end(), '-', '_'); // GoogleTest's names have no hyphens
                             return name + (std::get<1>(world.param) == HandHold::full ? "_full" : "_welded");
                         });

// Expected: one sentence with the link, the depth, the object and the settings that move it. The straight index ends at
// (81.1, -30.1, -10.4) mm; a sphere of 28 mm around a point 28.9 mm beyond reaches 5.6 mm into the capsule of 6.5 mm.
TEST(Clearance, an_object_inside_a_finger_is_refused_by_name)
{
    const auto setup = default_setup(
        {{"object.hinge_x_m", "0.11"}, {"object.hinge_y_m", "-0.0301"}, {"object.centre_z_m", "-0.0104"}});
    try {
        make_world(Stepper::reference, icub_hand(), read_object(TWIDDLE_MODELS, "small-sphere"), setup,
                   HandHold::welded);
        FAIL() << "a world was made";
    } catch (const std::runtime_error &error) {
        const std::string text = error.what();
        for (const char *part : {"hand_index_3", "5.6", " mm", "small-sphere", "hinge_x_m", "hinge_y_m", "centre_z_m"})
            EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

// Bullet's narrow phase between one capsule and the object's shape as the world makes it.
class BulletJudge
{
  public:
    BulletJudge(const ObjectBody &body, const settings::ObjectSetup &setup)
        : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &configuration_), object_(body, setup, 0.002)
    {
        still_.setCollisionShape(object_.collider().getCollisionShape());
    }

    // The deepest contact, if there is one: how deep, and the direction from the object to the capsule.
    std::optional<Overlap> overlap(const btTransform &X_object, const btTransform &X_capsule, btCapsuleShapeX &capsule)
    {
        still_.setWorldTransform(X_object);
        moving_.setCollisionShape(&capsule);
        moving_.setWorldTransform(X_capsule);
        Deepest deepest;
        deepest.capsule = &moving_;
        world_.contactPairTest(&still_, &moving_, deepest);
        return deepest.overlap;
    }

  private:
    struct Deepest : btCollisionWorld::ContactResultCallback {
        const btCollisionObject *capsule = nullptr;
        std::optional<Overlap> overlap;

        btScalar addSingleResult(btManifoldPoint &point, const btCollisionObjectWrapper *first, int, int,
                                 const btCollisionObjectWrapper *, int, int) override
        {
            const double depth_m = -point.getDistance();
            if (depth_m <= 0 || (overlap && overlap->depth_m >= depth_m)) return 0;
            // Bullet's normal points from the second body to the first.
            const double sign = first->getCollisionObject() == capsule ? 1 : -1;
            overlap = Overlap{depth_m, sign * point.m_normalWorldOnB};
            return 0;
        }
    };

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btCollisionWorld world_;
    HingedObject object_;
    btCollisionObject still_, moving_;
};

// A capsule of a length that the fingers' links have, at a random place around an object at a random angle.
struct Pose {
    double object_rad;
    double length_m;
    btTransform X_palm_capsule; // origin in the middle, along x

    btVector3 end_m(double side) const
    {
        return X_palm_capsule * btVector3(side * length_m / 2, 0, 0);
    }
};

Pose random_pose(const ObjectBody &body, std::mt19937_64 &random)
{
    constexpr std::array<double, 4> length_m = {0.0148, 0.0168, 0.022, 0.026};
    std::uniform_real_distribution<double> turn(-M_PI, M_PI), place_m(-0.07, 0.07);
    std::normal_distribution<double> normal;
    Pose pose;
    pose.object_rad = turn(random);
    pose.length_m = length_m[random() % length_m.size()];
    const btQuaternion rotation(normal(random), normal(random), normal(random), normal(random));
    const btVector3 offset_m(place_m(random), place_m(random), place_m(random));
    pose.X_palm_capsule = btTransform(rotation.normalized(), body.p_palm_centre_m + offset_m);
    return pose;
}

// The object without its rounding, whose nearest point to `p_object` is known in closed form.
btVector3 nearest_in_core(const ObjectBody &body, const btVector3 &p_object)
{
    if (body.shape == Shape::sphere) return {0, 0, 0};
    const double half_height_m = body.height_m / 2 - body.rounding_m;
    const double z_m = std::clamp(double(p_object.z()), -half_height_m, half_height_m);
    if (body.shape == Shape::cube) {
        const double half_side_m = body.side_m / 2 - body.rounding_m;
        return {std::clamp(double(p_object.x()), -half_side_m, half_side_m),
                std::clamp(double(p_object.y()), -half_side_m, half_side_m), z_m};
    }
    const double radius_m = body.radius_m - body.rounding_m;
    const double across_m = std::hypot(p_object.x(), p_object.y());
    const double scale = across_m > radius_m ? radius_m / across_m : 1;
    return {scale * p_object.x(), scale * p_object.y(), z_m};
}

// The overlap from the distance between the capsule's centre line and the object's core, a convex function along the
// line whose least value is found by thirds. For overlaps less deep than the capsule's radius; negative if apart.
Overlap exact_overlap(const ObjectBody &body, const Pose &pose)
{
    const btTransform X_palm_object(btQuaternion(btVector3(0, 0, 1), pose.object_rad), body.p_palm_centre_m);
    const auto gap_m = [&](double side) {
        const btVector3 p_object_m = X_palm_object.inverse() * pose.end_m(side);
        return p_object_m - nearest_in_core(body, p_object_m);
    };
    double low = -1, high = 1;
    while (high - low > 1e-9) {
        const double first = low + (high - low) / 3, second = high - (high - low) / 3;
        const bool before = gap_m(first).length2() < gap_m(second).length2();
        (before ? high : low) = before ? second : first;
    }
    const btVector3 shortest_m = gap_m((low + high) / 2);
    const double ball_m = body.shape == Shape::sphere ? body.radius_m : body.rounding_m;
    return Overlap{capsule_radius_m + ball_m - shortest_m.length(), X_palm_object.getBasis() * shortest_m.normalized()};
}

double angle_deg(const btVector3 &a, const btVector3 &b)
{
    return std::atan2(a.cross(b).length(), a.dot(b)) / deg;
}

// Sizes of something over all poses, and how they are told.
class Spread
{
  public:
    void add(double value)
    {
        values_.push_back(value);
    }
    double largest() const
    {
        return values_.empty() ? 0 : *std::max_element(values_.begin(), values_.end());
    }
    void print(const char *what, double scale)
    {
        std::sort(values_.begin(), values_.end());
        if (values_.empty()) return;
        std::printf("  %s:", what);
        for (const double share : {0.5, 0.95, 0.99, 1.0})
            std::printf(" %.3g (%g %%)", scale * values_[std::size_t(share * (values_.size() - 1))], 100 * share);
        std::printf("\n");
    }

  private:
    std::vector<double> values_;
};

constexpr double deepest_m = 1.5e-3; // of the poses; contacts in use are less deep
constexpr int poses = 1000;

// How well Bullet's contact with an object must be known.
struct ContactCase {
    const char *object;
    double depth_m;
    double normal_deg;
};

void PrintTo(const ContactCase &contact, std::ostream *stream)
{
    *stream << contact.object;
}

class Contact : public testing::TestWithParam<ContactCase>
{
  protected:
    // Calls judge(pose, Bullet's overlap if it sees one) for random poses that overlap by no more than deepest_m.
    template <class Judge> void for_random_poses(Judge &&judge)
    {
        constexpr unsigned seed = 4;
        std::printf("%s, seed %u, %d poses\n", GetParam().object, seed, poses);
        std::mt19937_64 random(seed);
        BulletJudge bullet(body_, setup_);
        for (int found = 0; found < poses;) {
            const Pose pose = random_pose(body_, random);
            const double depth_m = exact_overlap(body_, pose).depth_m;
            if (depth_m <= 0 || depth_m > deepest_m) continue;
            btCapsuleShapeX capsule(capsule_radius_m, pose.length_m);
            const btTransform X_object(btQuaternion(btVector3(0, 0, 1), pose.object_rad), body_.p_palm_centre_m);
            judge(pose, bullet.overlap(X_object, pose.X_palm_capsule, capsule));
            ++found;
        }
    }

    // libccd's verdict on the pose with the capsule moved by `move_m`.
    std::optional<Overlap> mpr(const Pose &pose, const btVector3 &move_m) const
    {
        return capsule_overlap(body_, pose.object_rad, pose.end_m(-1) + move_m, pose.end_m(1) + move_m,
                               capsule_radius_m);
    }

    const settings::ObjectSetup setup_ = default_setup().object;
    const ObjectBody body_ = object_body(read_object(TWIDDLE_MODELS, GetParam().object), setup_);
};

// Expected: the closed-form distance between a segment and sphere, rounded cylinder or rounded box.
TEST_P(Contact, of_bullet_has_the_closed_forms_depth_and_normal)
{
    Spread depth_m, normal_deg;
    int missed = 0;
    for_random_poses([&](const Pose &pose, const std::optional<Overlap> &bullet) {
        const Overlap exact = exact_overlap(body_, pose);
        depth_m.add(std::abs((bullet ? bullet->depth_m : 0) - exact.depth_m));
        if (bullet) normal_deg.add(angle_deg(bullet->direction, exact.direction));
        if (!bullet) ++missed;
    });
    std::printf("  not seen by Bullet: %d\n", missed);
    depth_m.print("error of the depth in um", 1e6);
    normal_deg.print("error of the normal in deg", 1);
    EXPECT_LE(depth_m.largest(), GetParam().depth_m);
    EXPECT_LE(normal_deg.largest(), GetParam().normal_deg);
}

// Expected: MPR's verdict, touching or not. Moving the capsule along Bullet's normal by Bullet's depth and a tolerance
// separates the two; moving it by the depth less the tolerance does not, along the normal or along any other of 20
// random directions, so that the depth is the least there is.
TEST_P(Contact, of_bullet_is_the_shortest_way_out_that_mpr_finds)
{
    constexpr unsigned seed = 5;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const double tolerance_m = GetParam().depth_m;
    int still_touching = 0, already_apart = 0;
    for_random_poses([&](const Pose &pose, const std::optional<Overlap> &bullet) {
        if (!bullet) return;
        if (mpr(pose, (bullet->depth_m + tolerance_m) * bullet->direction)) ++still_touching;
        if (bullet->depth_m <= tolerance_m) return;
        if (!mpr(pose, (bullet->depth_m - tolerance_m) * bullet->direction)) ++already_apart;
        for (int i = 0; i < 20; ++i) {
            const btVector3 direction = btVector3(normal(random), normal(random), normal(random)).normalized();
            if (!mpr(pose, (bullet->depth_m - tolerance_m) * direction)) ++already_apart;
        }
    });
    EXPECT_EQ(still_touching, 0);
    EXPECT_EQ(already_apart, 0);
}

// Expected: MPR's depth is that of one way out, hence never less than Bullet's, which is the least; and the two agree
// in most poses. MPR looks along the line between the bodies' centres: far from it, at rims and ends, its estimate is
// coarse, and its direction there says little.
TEST_P(Contact, of_bullet_is_no_deeper_than_mpr_estimates)
{
    Spread excess_m, shortfall_m, normal_deg;
    for_random_poses([&](const Pose &pose, const std::optional<Overlap> &bullet) {
        const auto estimate = mpr(pose, btVector3(0, 0, 0));
        const double difference_m = (estimate ? estimate->depth_m : 0) - (bullet ? bullet->depth_m : 0);
        excess_m.add(std::max(0.0, difference_m));
        shortfall_m.add(std::max(0.0, -difference_m));
        if (estimate && bullet) normal_deg.add(angle_deg(bullet->direction, estimate->direction));
    });
    excess_m.print("MPR deeper by um", 1e6);
    shortfall_m.print("Bullet deeper by um", 1e6);
    normal_deg.print("angle between the normals in deg", 1);
    EXPECT_LE(shortfall_m.largest(), 1e-6);
}

// Bullet's GJK ends on absolute tolerances made for bodies of a metre: on the curved side of a cylinder of
// centimetres it ends early (by 0.1 mm at most, and the error falls with the square of the scale), at a cube's
// edges by micrometres.
INSTANTIATE_TEST_SUITE_P(Sim, Contact,
                         testing::Values(ContactCase{"small-sphere", 1e-6, 0.01},
                                         ContactCase{"medium-cylinder", 200e-6, 8},
                                         ContactCase{"large-cube", 10e-6, 0.1}),
                         [](const auto &contact) {
                             std::string name = contact.param.object;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace
} // namespace twiddle::sim
