#include "world.hpp"

#include "clearance.hpp"
#include "cone_friction_solver.hpp"
#include "hinged_object.hpp"
#include "joint_stop.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <algorithm>

namespace twiddle::sim
{

namespace
{

constexpr double control_step_s = 0.01; // the paper's

// Collision groups. A link meets the object, and the other finger if the set-up says so; nothing else.
enum Group { group_none = 0, group_index = 1 << 6, group_thumb = 1 << 7, group_other = 1 << 8, group_object = 1 << 9 };

int group_of(Finger finger)
{
    if (finger == Finger::index) return group_index;
    if (finger == Finger::thumb) return group_thumb;
    return group_other;
}

int mask_of(Finger finger, bool index_thumb_contact)
{
    if (finger == Finger::other) return group_none;
    const int other = finger == Finger::index ? group_thumb : group_index;
    return index_thumb_contact ? group_object | other : group_object;
}

// All in Bullet that remembers: contact caches, pair caches, bounding-box trees, solver buffers. Their order of entries would
// let one trial leak into the next, so that a reset builds them anew; bodies and shapes stay.
struct Stage {
    Stage()
        : configuration(small_pools()), dispatcher(&configuration),
          world(&dispatcher, &broadphase, &solver, &configuration)
    {
    }

    // The default pools are for thousands of bodies and would cost more to set up than a trial's first steps.
    static btDefaultCollisionConstructionInfo small_pools()
    {
        btDefaultCollisionConstructionInfo info;
        info.m_defaultMaxPersistentManifoldPoolSize = 64;
        info.m_defaultMaxCollisionAlgorithmPoolSize = 64;
        return info;
    }

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    ConeFrictionSolver solver;
    btMultiBodyDynamicsWorld world;
};

} // namespace

struct World::Impl {
    Impl(const HandModel &model, const ObjectSpec &spec, const Setup &set_up, HandHold hold)
        : setup(set_up), substep_s(control_step_s / set_up.physics.substeps), hand(model, set_up.hand, hold),
          object_shape(object_body(spec, set_up.object)), object(object_shape, set_up.object, substep_s)
    {
        require_clearance(hand, object_shape, spec.name);
        make_joint_constraints();
        reset();
    }

    void reset()
    {
        stage.reset();
        hand.reset();
        object.reset();
        for (auto &constraint : joint_constraints)
            clear_impulses(*constraint);
        clear_impulses(object.coulomb_friction());
        stage = std::make_unique<Stage>();
        configure_solver();
        stage->world.setGravity(gravity_palm_m_s2());
        add_bodies();
    }

    static void clear_impulses(btMultiBodyConstraint &constraint)
    {
        for (int row = 0; row < constraint.getNumRows(); row++)
            constraint.internalSetAppliedImpulse(row, 0);
    }

    void configure_solver()
    {
        // Bullet keeps this threshold in a global. Contacts are made before they touch, so that a fast tip cannot tunnel.
        gContactBreakingThreshold = setup.physics.breaking_threshold_m;
        btCollisionDispatcher &dispatcher = stage->dispatcher;
        dispatcher.setDispatcherFlags(dispatcher.getDispatcherFlags() &
                                      ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
        btContactSolverInfo &info = stage->world.getSolverInfo();
        info.m_numIterations = setup.physics.solver_iterations;
        info.m_leastSquaresResidualThreshold = setup.physics.solver_residual;
        info.m_erp = setup.physics.error_reduction;
        info.m_erp2 = setup.physics.error_reduction;
        info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    }

    btVector3 gravity_palm_m_s2() const
    {
        const auto &d = setup.physics.gravity_direction;
        const btVector3 direction_hand(d[0], d[1], d[2]);
        return X_hand_palm().getBasis().transpose() * direction_hand * setup.physics.gravity_m_s2;
    }

    void add_bodies()
    {
        btMultiBodyDynamicsWorld &world = stage->world;
        world.addMultiBody(&hand.body());
        world.addMultiBody(&object.body());
        for (int i = 0; i < static_cast<int>(hand.links().size()); i++) {
            const Finger finger = hand.links()[i].finger;
            btMultiBodyLinkCollider &collider = hand.collider(i);
            collider.setFriction(1);
            collider.setRestitution(0);
            world.addCollisionObject(&collider, group_of(finger), mask_of(finger, setup.physics.index_thumb_contact));
        }
        // Bullet multiplies the two friction coefficients of a pair.
        object.collider().setFriction(setup.physics.friction);
        object.collider().setRestitution(0);
        world.addCollisionObject(&object.collider(), group_object, group_index | group_thumb);
        for (auto &constraint : joint_constraints)
            world.addMultiBodyConstraint(constraint.get());
        world.addMultiBodyConstraint(&object.coulomb_friction());
    }

    void make_joint_constraints()
    {
        const double largest_impulse_nms = setup.hand.torque_limit_nm * substep_s;
        for (const ArticulatedLink &link : hand.links()) {
            if (!link.moves) continue;
            const HandLink &model = hand.model().links[link.model_link];
            joint_constraints.push_back(std::make_unique<JointStop>(hand.body(), link.body_link, model.lower_rad,
                                                                    model.upper_rad, setup.physics.error_reduction));
            const auto &driven = hand.controlled();
            if (std::find(driven.begin(), driven.end(), link.body_link) != driven.end()) continue;
            auto motor =
                std::make_unique<btMultiBodyJointMotor>(&hand.body(), link.body_link, 0.0, largest_impulse_nms);
            motor->setPositionTarget(link.held_rad, 0.5);
            motor->setVelocityTarget(0, 1);
            joint_constraints.push_back(std::move(motor));
        }
        // Bullet would do this at the first step, after an impulse of theirs was asked for.
        for (auto &constraint : joint_constraints)
            constraint->finalizeMultiDof();
    }

    void sum_contacts(Observation &seen)
    {
        for (int m = 0; m < stage->dispatcher.getNumManifolds(); m++) {
            const btPersistentManifold *manifold = stage->dispatcher.getManifoldByIndexInternal(m);
            const auto *first = btMultiBodyLinkCollider::upcast(manifold->getBody0());
            const auto *second = btMultiBodyLinkCollider::upcast(manifold->getBody1());
            const auto *link = first->m_multiBody == &hand.body() ? first : second;
            const bool with_object = first->m_multiBody != second->m_multiBody;
            if (!with_object) continue;
            double impulse_ns = 0;
            for (int c = 0; c < manifold->getNumContacts(); c++) {
                impulse_ns += manifold->getContactPoint(c).getAppliedImpulse();
                seen.deepest_m = std::max(seen.deepest_m, -double(manifold->getContactPoint(c).getDistance()));
            }
            const bool index = hand.finger_of(link->m_link) == Finger::index;
            (index ? seen.index_contact_n : seen.thumb_contact_n) += impulse_ns / substep_s;
        }
    }

    const Setup setup;
    const double substep_s;
    ArticulatedHand hand;
    const ObjectBody object_shape;
    HingedObject object;
    std::vector<std::unique_ptr<btMultiBodyConstraint>> joint_constraints;
    std::unique_ptr<Stage> stage;
};

World::World(const HandModel &hand, const ObjectSpec &object, const Setup &setup, HandHold hold)
    : impl_(std::make_unique<Impl>(hand, object, setup, hold))
{
}

World::~World() = default;
World::World(World &&) noexcept = default;
World &World::operator=(World &&) noexcept = default;

void World::reset()
{
    impl_->reset();
}

void World::substep(const JointVector &torque_nm)
{
    btMultiBody &body = impl_->hand.body();
    const double limit_nm = impl_->setup.hand.torque_limit_nm;
    for (std::size_t j = 0; j < joint_count; j++) {
        body.addJointTorque(impl_->hand.controlled()[j], std::clamp(torque_nm[j], -limit_nm, limit_nm));
    }
    impl_->object.apply_viscous_friction();
    impl_->stage->world.stepSimulation(impl_->substep_s, 0);
    impl_->hand.place_colliders();
}

JointVector World::angles_rad() const
{
    JointVector angle_rad;
    for (std::size_t j = 0; j < joint_count; j++) {
        angle_rad[j] = impl_->hand.body().getJointPos(impl_->hand.controlled()[j]);
    }
    return angle_rad;
}

JointVector World::velocities_rad_s() const
{
    JointVector velocity_rad_s;
    for (std::size_t j = 0; j < joint_count; j++) {
        velocity_rad_s[j] = impl_->hand.body().getJointVel(impl_->hand.controlled()[j]);
    }
    return velocity_rad_s;
}

double World::object_rotation_rad() const
{
    return impl_->setup.object.counted_direction * impl_->object.angle_rad();
}

Observation World::observe() const
{
    Observation seen;
    seen.angle_rad = angles_rad();
    seen.velocity_rad_s = velocities_rad_s();
    seen.p_palm_index_tip_m = impl_->hand.p_palm_tip_m(Finger::index);
    seen.p_palm_thumb_tip_m = impl_->hand.p_palm_tip_m(Finger::thumb);
    seen.object_rad = object_rotation_rad();
    impl_->sum_contacts(seen);
    seen.finger_clearance_m = finger_clearance_m(impl_->hand);
    return seen;
}

int World::substeps_per_step() const
{
    return impl_->setup.physics.substeps;
}

} // namespace twiddle::sim
