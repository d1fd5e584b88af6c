// articulated_hand.hpp: the hand of hand_model.hpp as a Bullet multibody.
#pragma once

#include "hand_model.hpp"
#include "settings/joints.hpp"
#include "settings/setup.hpp"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <array>
#include <memory>
#include <vector>

namespace twiddle::sim
{

// welded: the fingers' held joints are rigid, and the fingers without a controlled joint are left out.
// full: all 19 joints move; the fifteen others are to be held by motors (reference/reference_world.cpp).
enum class HandHold { welded, full };

// Which finger a link belongs to; contacts are told apart by it.
enum class Finger { index, thumb, other };

// One link of the model as it takes part in the simulation. Links that cannot move against each other share one Bullet
// link, whose frame is the principal frame at their common centre of mass.
struct ArticulatedLink {
    int model_link = 0; // index into HandModel::links
    Finger finger = Finger::other;
    bool moves = false;                                   // revolute in Bullet; otherwise rigid
    double held_rad = 0;                                  // angle of a joint that the controller does not drive
    int body_link = 0;                                    // the Bullet link that carries it
    btTransform X_body_link = btTransform::getIdentity(); // the model link's frame in the Bullet link's
};

class ArticulatedHand
{
  public:
    // Builds the multibody with the palm at X_palm_hand. Throws std::runtime_error if the model lacks a
    // controlled joint.
    ArticulatedHand(const HandModel &model, const settings::HandSetup &setup, HandHold hold);

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
    // Parents before children.
    const std::vector<ArticulatedLink> &links() const
    {
        return links_;
    }
    // Bullet link of each controlled joint.
    const std::array<int, joint_count> &controlled() const
    {
        return controlled_;
    }
    // The finger that a Bullet link belongs to.
    Finger finger_of(int body_link) const;
    // The capsule of links()[link].
    btMultiBodyLinkCollider &collider(int link)
    {
        return *colliders_[link];
    }
    const Capsule &capsule(int link) const
    {
        return model_.links[links_[link].model_link].capsule;
    }

    // Joints to their starting angles, everything at rest; kinematic caches and colliders follow.
    void reset();

    // Set the angles of all moving joints at once, in the order of links() (rigid ones skipped), and update caches.
    void set_posture(const std::vector<double> &angle_rad);

    // Bring link frames and colliders to where the multibody is; Bullet itself places only one collider a Bullet link.
    // To be called after each step of the world.
    void place_colliders();

    // The frame of links()[link] in the palm frame.
    btTransform X_palm_link(int link) const;
    // Centre of the last link's distal end sphere.
    btVector3 p_palm_tip_m(Finger finger) const;
    // Centre line of a link's capsule, from the link's origin outwards.
    std::array<btVector3, 2> p_palm_capsule_m(int link) const;

  private:
    void select_links(const settings::HandSetup &setup, HandHold hold);
    void build_body(double reflected_inertia_kg_m2);
    void add_body_link(int body_link, double reflected_inertia_kg_m2);
    void add_collider(int link);
    // Index into links_ of the link that `model_link` hangs on; -1 for the palm.
    int parent_of(int model_link) const;

    HandModel model_;
    std::vector<ArticulatedLink> links_;
    std::array<int, joint_count> controlled_{};
    std::unique_ptr<btMultiBody> body_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
    btAlignedObjectArray<btQuaternion> scratch_rotation_;
    btAlignedObjectArray<btVector3> scratch_vector_;
};

} // namespace twiddle::sim
