#include "articulated_hand.hpp"

#include <BulletCollision/CollisionShapes/btCapsuleShape.h>

#include <algorithm>
#include <stdexcept>

namespace twiddle::sim
{

namespace
{

// Index of the first link of the finger that `link` belongs to.
int root_of(const HandModel &model, int link)
{
    while (model.links[link].parent >= 0)
        link = model.links[link].parent;
    return link;
}

double held_angle_rad(const HandSetup &setup, Finger finger)
{
    constexpr double rad_per_deg = SIMD_RADS_PER_DEG;
    if (finger == Finger::index) return setup.index_distal_deg * rad_per_deg;
    if (finger == Finger::thumb) return setup.thumb_distal_deg * rad_per_deg;
    return setup.other_fingers_deg * rad_per_deg;
}

// The link's inertia with the drive's reflected inertia about its joint axis, as principal frame and moments.
btTransform principal_frame(const HandLink &link, double reflected_inertia_kg_m2, btVector3 &moments_kg_m2)
{
    btMatrix3x3 inertia = link.inertia_kg_m2;
    inertia[2][2] += reflected_inertia_kg_m2;
    btMatrix3x3 rotation = btMatrix3x3::getIdentity();
    inertia.diagonalize(rotation, 1e-12, 50);
    moments_kg_m2.setValue(inertia[0][0], inertia[1][1], inertia[2][2]);
    return btTransform(rotation, link.p_link_com_m);
}

} // namespace

ArticulatedHand::ArticulatedHand(const HandModel &model, const HandSetup &setup, HandHold hold)
    : model_(model), reflected_inertia_kg_m2_(setup.reflected_inertia_kg_m2)
{
    std::array<int, joint_count> driven{};
    for (std::size_t j = 0; j < joint_count; j++)
        driven[j] = model_.link_of_joint(joint_urdf_names[j]);
    const int index_root = root_of(model_, driven[fei]);
    const int thumb_root = root_of(model_, driven[fet]);

    std::vector<int> bullet_link_of(model_.links.size(), -1);
    for (int i = 0; i < static_cast<int>(model_.links.size()); i++) {
        const int root = root_of(model_, i);
        const Finger finger = root == index_root ? Finger::index : root == thumb_root ? Finger::thumb : Finger::other;
        if (hold == HandHold::welded && finger == Finger::other) continue;
        const bool is_driven = std::find(driven.begin(), driven.end(), i) != driven.end();
        ArticulatedLink link;
        link.model_link = i;
        link.finger = finger;
        link.moves = model_.links[i].revolute && (is_driven || hold == HandHold::full);
        link.held_rad = is_driven || !model_.links[i].revolute ? 0 : held_angle_rad(setup, finger);
        bullet_link_of[i] = static_cast<int>(links_.size());
        links_.push_back(link);
    }
    for (std::size_t j = 0; j < joint_count; j++)
        controlled_[j] = bullet_link_of[driven[j]];

    const int count = static_cast<int>(links_.size());
    body_ = std::make_unique<btMultiBody>(count, 0, btVector3(0, 0, 0), true, false);
    for (int i = 0; i < count; i++)
        add_link(i);
    body_->finalizeMultiDof();
    // Bullet's defaults are for games: damping, a speed limit and an impulse limit that this hand would meet.
    body_->setLinearDamping(0);
    body_->setAngularDamping(0);
    body_->setMaxCoordinateVelocity(1e5);
    body_->setMaxAppliedImpulse(1e5);
    body_->setHasSelfCollision(true);
    for (int i = 0; i < count; i++)
        add_collider(i);
    reset();
}

void ArticulatedHand::add_link(int bullet_link)
{
    ArticulatedLink &link = links_[bullet_link];
    const HandLink &model = model_.links[link.model_link];
    btVector3 moments_kg_m2;
    link.X_link_principal = principal_frame(model, reflected_inertia_kg_m2_, moments_kg_m2);

    int parent = -1;
    btTransform X_parent_principal = btTransform::getIdentity();
    for (int i = 0; i < bullet_link; i++) {
        if (links_[i].model_link != model.parent) continue;
        parent = i;
        X_parent_principal = links_[i].X_link_principal;
    }
    // A rigid joint's held angle is part of its frame; a moving joint starts at angle 0.
    const double rigid_rad = link.moves ? 0 : link.held_rad;
    const btTransform turn(btQuaternion(btVector3(0, 0, 1), rigid_rad));
    const btTransform X_principal_joint = X_parent_principal.inverse() * model.X_parent_joint * turn;
    const btTransform X_joint_principal = link.X_link_principal;
    btQuaternion parent_to_this;
    (X_principal_joint.getBasis() * X_joint_principal.getBasis()).transpose().getRotation(parent_to_this);
    const btVector3 p_this_com = X_joint_principal.getBasis().transpose() * model.p_link_com_m;
    if (link.moves) {
        const btVector3 axis = X_joint_principal.getBasis().transpose() * btVector3(0, 0, 1);
        body_->setupRevolute(bullet_link, model.mass_kg, moments_kg_m2, parent, parent_to_this, axis,
                             X_principal_joint.getOrigin(), p_this_com, true);
    } else {
        body_->setupFixed(bullet_link, model.mass_kg, moments_kg_m2, parent, parent_to_this,
                          X_principal_joint.getOrigin(), p_this_com, true);
    }
}

void ArticulatedHand::add_collider(int bullet_link)
{
    const ArticulatedLink &link = links_[bullet_link];
    const HandLink &model = model_.links[link.model_link];
    const btVector3 p_link_middle_m(model.capsule.length_m / 2, 0, 0);
    if ((p_link_middle_m - model.p_link_com_m).length() > 1e-9) {
        throw std::runtime_error("link " + model.name + ": its centre of mass must be the middle of its capsule");
    }
    auto shape = std::make_unique<btCapsuleShapeX>(model.capsule.radius_m, model.capsule.length_m);
    auto collider = std::make_unique<btMultiBodyLinkCollider>(body_.get(), bullet_link);
    collider->setCollisionShape(shape.get());
    collider->setActivationState(DISABLE_DEACTIVATION);
    body_->getLink(bullet_link).m_collider = collider.get();
    shapes_.push_back(std::move(shape));
    colliders_.push_back(std::move(collider));
}

void ArticulatedHand::reset()
{
    body_->clearForcesAndTorques();
    body_->clearVelocities();
    // Bullet normalises even a fixed base's rotation at every step, so that its last digits wander.
    const btTransform X_palm_hand = X_hand_palm().inverse();
    body_->setBasePos(X_palm_hand.getOrigin());
    body_->setWorldToBaseRot(X_palm_hand.getRotation().inverse());
    for (int i = 0; i < body_->getNumLinks(); i++) {
        if (!links_[i].moves) continue;
        body_->setJointPos(i, links_[i].held_rad);
        body_->setJointVel(i, 0);
    }
    update_kinematics();
}

void ArticulatedHand::set_posture(const std::vector<double> &angle_rad)
{
    std::size_t next = 0;
    for (int i = 0; i < body_->getNumLinks(); i++) {
        if (links_[i].moves) body_->setJointPos(i, angle_rad.at(next++));
    }
    update_kinematics();
}

void ArticulatedHand::update_kinematics()
{
    body_->forwardKinematics(scratch_rotation_, scratch_vector_);
    body_->updateCollisionObjectWorldTransforms(scratch_rotation_, scratch_vector_);
}

btTransform ArticulatedHand::X_palm_link(int bullet_link) const
{
    const btTransform &X_palm_principal = colliders_[bullet_link]->getWorldTransform();
    return X_palm_principal * links_[bullet_link].X_link_principal.inverse();
}

const Capsule &ArticulatedHand::capsule(int bullet_link) const
{
    return model_.links[links_[bullet_link].model_link].capsule;
}

std::array<btVector3, 2> ArticulatedHand::p_palm_capsule_m(int bullet_link) const
{
    const btTransform X = X_palm_link(bullet_link);
    return {X.getOrigin(), X * btVector3(capsule(bullet_link).length_m, 0, 0)};
}

btVector3 ArticulatedHand::p_palm_tip_m(Finger finger) const
{
    for (int i = body_->getNumLinks() - 1; i >= 0; i--) {
        if (links_[i].finger == finger) return p_palm_capsule_m(i)[1];
    }
    throw std::logic_error("the hand has no such finger");
}

} // namespace twiddle::sim
