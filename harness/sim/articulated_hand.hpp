// articulated_hand.hpp: the hand of hand_model.hpp as a Bullet multibody.
#pragma once

#include "hand_model.hpp"
#include "joints.hpp"
#include "setup.hpp"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <array>
#include <memory>
#include <vector>

namespace twiddle::sim
{

// welded: the fingers' held joints are rigid, and the fingers without a controlled joint are left out.
// full: all 19 joints move; the fifteen others are to be held by motors (hand_holds.hpp).
enum class HandHold { welded, full };

// Which finger a link belongs to; contacts are told apart by it.
enum class Finger { index, thumb, other };

// One Bullet link and where it came from. Bullet's link frame is the principal frame at the centre of mass.
struct ArticulatedLink {
    int model_link = 0; // index into HandModel::links
    Finger finger = Finger::other;
    bool moves = false;                                        // revolute in Bullet; otherwise rigid
    double held_rad = 0;                                       // angle of a joint that the controller does not drive
    btTransform X_link_principal = btTransform::getIdentity(); // Bullet's frame in the URDF link's frame
};

class ArticulatedHand
{
  public:
    // Builds the multibody with the palm at X_palm_hand. Throws std::runtime_error if the model lacks a controlled joint.
    ArticulatedHand(const HandModel &model, const HandSetup &setup, HandHold hold);

    btMultiBody &body()
    {
        return *body_;
    }
    const btMultiBody &body() const
    {
        return *body_;
    }
    const HandModel &model() const
    {
        return model_;
    }
    // [number of Bullet links]
    const std::vector<ArticulatedLink> &links() const
    {
        return links_;
    }
    // Bullet link of each controlled joint.
    const std::array<int, joint_count> &controlled() const
    {
        return controlled_;
    }

    // Joints to their starting angles, everything at rest; kinematic caches and colliders follow.
    void reset();

    // Set the angles of all moving joints at once, in the order of links() (rigid ones skipped), and update caches.
    void set_posture(const std::vector<double> &angle_rad);

    // The URDF link's frame in the palm frame.
    btTransform X_palm_link(int bullet_link) const;
    // Centre of the last link's distal end sphere.
    btVector3 p_palm_tip_m(Finger finger) const;
    // Centre line of a link's capsule, from the link's origin outwards.
    std::array<btVector3, 2> p_palm_capsule_m(int bullet_link) const;
    const Capsule &capsule(int bullet_link) const;

  private:
    void add_link(int bullet_link);
    void add_collider(int bullet_link);
    void update_kinematics();

    HandModel model_;
    std::vector<ArticulatedLink> links_;
    std::array<int, joint_count> controlled_{};
    double reflected_inertia_kg_m2_;
    std::unique_ptr<btMultiBody> body_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
    btAlignedObjectArray<btQuaternion> scratch_rotation_;
    btAlignedObjectArray<btVector3> scratch_vector_;
};

} // namespace twiddle::sim
