#include "articulated_hand.hpp"

#include "settings/constants.hpp"

#include "rigid_group.hpp"

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

double held_angle_rad(const settings::HandSetup &setup, Finger finger)
{
    if (finger == Finger::index) return setup.index_distal_deg * rad_per_deg;
    if (finger == Finger::thumb) return setup.thumb_distal_deg * rad_per_deg;
    return setup.other_fingers_deg * rad_per_deg;
}

bool contains(const std::array<int, joint_count> &list, int value)
{
    return std::find(list.begin(), list.end(), value) != list.end();
}

} // namespace

ArticulatedHand::ArticulatedHand(const HandModel &model, const settings::HandSetup &setup, HandHold hold)
    : model_(model)
{
    select_links(setup, hold);
    build_body(setup.reflected_inertia_kg_m2);
    for (int i = 0; i < static_cast<int>(links_.size()); i++)
        add_collider(i);
    reset();
}

int ArticulatedHand::parent_of(int model_link) const
{
    for (int i = 0; i < static_cast<int>(links_.size()); i++) {
        if (links_[i].model_link == model_.links[model_link].parent) return i;
    }
    return -1;
}

void ArticulatedHand::select_links(const settings::HandSetup &setup, HandHold hold)
{
    std::array<int, joint_count> driven{};
    for (std::size_t j = 0; j < joint_count; j++)
        driven[j] = model_.link_of_joint(joint_urdf_names[j]);
    const int index_root = root_of(model_, driven[fei]);
    const int thumb_root = root_of(model_, driven[fet]);
    int body_links = 0;
    for (int i = 0; i < static_cast<int>(model_.links.size()); i++) {
        const int root = root_of(model_, i);
        const Finger finger = root == index_root ? Finger::index : root == thumb_root ? Finger::thumb : Finger::other;
        if (hold == HandHold::welded && finger == Finger::other) continue;
        ArticulatedLink link;
        link.model_link = i;
        link.finger = finger;
        link.moves = model_.links[i].revolute && (contains(driven, i) || hold == HandHold::full);
        link.held_rad = contains(driven, i) || !model_.links[i].revolute ? 0 : held_angle_rad(setup, finger);
        const int parent = parent_of(i);
        const bool own_body_link = link.moves || parent < 0;
        link.body_link = own_body_link ? body_links++ : links_[parent].body_link;
        links_.push_back(link);
        for (std::size_t j = 0; j < joint_count; j++) {
            if (driven[j] == i) controlled_[j] = link.body_link;
        }
    }
}

void ArticulatedHand::build_body(double reflected_inertia_kg_m2)
{
    const int count = links_.empty() ? 0 : 1 + links_.back().body_link;
    body_ = std::make_unique<btMultiBody>(count, 0, btVector3(0, 0, 0), true, false);
    for (int i = 0; i < count; i++)
        add_body_link(i, reflected_inertia_kg_m2);
    body_->finalizeMultiDof();
    // Bullet's defaults are for games: damping, a speed limit and an impulse limit that this hand would meet.
    body_->setLinearDamping(0);
    body_->setAngularDamping(0);
    body_->setMaxCoordinateVelocity(1e5);
    body_->setMaxAppliedImpulse(1e5);
    body_->setHasSelfCollision(true);
}

void ArticulatedHand::add_body_link(int body_link, double reflected_inertia_kg_m2)
{
    // The group's frame is that of its first link; a rigid joint's held angle is part of the frames.
    RigidGroup group;
    std::vector<btTransform> X_group_link(links_.size());
    int first = -1;
    for (int i = 0; i < static_cast<int>(links_.size()); i++) {
        if (links_[i].body_link != body_link) continue;
        const HandLink &model = model_.links[links_[i].model_link];
        X_group_link[i] = btTransform::getIdentity();
        if (first < 0) {
            first = i;
        } else {
            const btTransform turn(btQuaternion(btVector3(0, 0, 1), links_[i].held_rad));
            X_group_link[i] = X_group_link[parent_of(links_[i].model_link)] * model.X_parent_joint * turn;
        }
        group.add(model, X_group_link[i], reflected_inertia_kg_m2);
    }
    btVector3 moments_kg_m2;
    const btTransform X_group_principal = group.X_group_principal(moments_kg_m2);
    for (int i = first; i < static_cast<int>(links_.size()); i++) {
        if (links_[i].body_link == body_link) links_[i].X_body_link = X_group_principal.inverse() * X_group_link[i];
    }

    const ArticulatedLink &link = links_[first];
    const HandLink &model = model_.links[link.model_link];
    const int parent = parent_of(link.model_link);
    const btTransform turn(btQuaternion(btVector3(0, 0, 1), link.moves ? 0 : link.held_rad));
    btTransform X_parent_group = model.X_parent_joint * turn;
    if (parent >= 0) X_parent_group = links_[parent].X_body_link * X_parent_group;
    btQuaternion parent_to_this;
    (X_parent_group.getBasis() * X_group_principal.getBasis()).transpose().getRotation(parent_to_this);
    const btMatrix3x3 R_principal_group = X_group_principal.getBasis().transpose();
    const btVector3 p_this_com_m = R_principal_group * X_group_principal.getOrigin();
    const int parent_body_link = parent >= 0 ? links_[parent].body_link : -1;
    if (link.moves) {
        body_->setupRevolute(body_link, group.mass_kg(), moments_kg_m2, parent_body_link, parent_to_this,
                             R_principal_group * btVector3(0, 0, 1), X_parent_group.getOrigin(), p_this_com_m, true);
    } else {
        body_->setupFixed(body_link, group.mass_kg(), moments_kg_m2, parent_body_link, parent_to_this,
                          X_parent_group.getOrigin(), p_this_com_m, true);
    }
}

void ArticulatedHand::add_collider(int link)
{
    const int body_link = links_[link].body_link;
    auto shape = std::make_unique<btCapsuleShapeX>(capsule(link).radius_m, capsule(link).length_m);
    auto collider = std::make_unique<btMultiBodyLinkCollider>(body_.get(), body_link);
    collider->setCollisionShape(shape.get());
    collider->setActivationState(DISABLE_DEACTIVATION);
    // Bullet keeps a Bullet link's frame up to date only if it has a collider, whichever that is.
    body_->getLink(body_link).m_collider = collider.get();
    shapes_.push_back(std::move(shape));
    colliders_.push_back(std::move(collider));
}

void ArticulatedHand::reset()
{
    body_->clearForcesAndTorques();
    body_->clearVelocities();
    // Bullet normalises even a fixed base's rotation at every step, so that its last digits wander.
    const btTransform X_palm_hand = model_.X_hand_palm.inverse();
    body_->setBasePos(X_palm_hand.getOrigin());
    body_->setWorldToBaseRot(X_palm_hand.getRotation().inverse());
    for (const ArticulatedLink &link : links_) {
        if (link.moves) body_->setJointPos(link.body_link, link.held_rad);
    }
    place_colliders();
}

void ArticulatedHand::set_posture(const std::vector<double> &angle_rad)
{
    std::size_t next = 0;
    for (const ArticulatedLink &link : links_) {
        if (link.moves) body_->setJointPos(link.body_link, angle_rad.at(next++));
    }
    place_colliders();
}

void ArticulatedHand::place_colliders()
{
    body_->forwardKinematics(scratch_rotation_, scratch_vector_);
    for (int i = 0; i < static_cast<int>(links_.size()); i++) {
        const btTransform X_link_capsule(btQuaternion::getIdentity(), btVector3(capsule(i).length_m / 2, 0, 0));
        colliders_[i]->setWorldTransform(X_palm_link(i) * X_link_capsule);
    }
}

btTransform ArticulatedHand::X_palm_link(int link) const
{
    return body_->getLink(links_[link].body_link).m_cachedWorldTransform * links_[link].X_body_link;
}

Finger ArticulatedHand::finger_of(int body_link) const
{
    for (const ArticulatedLink &link : links_) {
        if (link.body_link == body_link) return link.finger;
    }
    return Finger::other;
}

std::array<btVector3, 2> ArticulatedHand::p_palm_capsule_m(int link) const
{
    const btTransform X = X_palm_link(link);
    return {X.getOrigin(), X * btVector3(capsule(link).length_m, 0, 0)};
}

btVector3 ArticulatedHand::p_palm_tip_m(Finger finger) const
{
    for (int i = static_cast<int>(links_.size()) - 1; i >= 0; i--) {
        if (links_[i].finger == finger) return p_palm_capsule_m(i)[1];
    }
    throw std::logic_error("the hand has no such finger");
}

} // namespace twiddle::sim
