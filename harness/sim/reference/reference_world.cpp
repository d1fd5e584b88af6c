#include "reference_world.hpp"

#include "cone_friction_solver.hpp"
#include "hinged_object.hpp"
#include "joint_stop.hpp"
#include "settings/constants.hpp"
#include "sim/clearance.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <algorithm>

namespace twiddle::sim
{

namespace
{

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

// All in Bullet that remembers: contact caches, pair caches, bounding-box trees, solver buffers. Their order of entries
// would let one trial leak into the next, so that a reset builds them anew; bodies and shapes stay.
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

class ReferenceWorld final : public World
{
  public:
    ReferenceWorld(const HandModel &model, const ObjectSpec &spec, const settings::Setup &set_up, HandHold hold)
        : setup_(set_up), substep_s_(control_step_s / set_up.physics.substeps), hand_(model, set_up.hand, hold),
          object_shape_(object_body(spec, set_up.object)), object_(object_shape_, set_up.object, substep_s_)
    {
        require_clearance(hand_, object_shape_, spec.name);
        make_joint_constraints();
        restart();
    }

    void reset() override
    {
        restart();
    }

    void substep(const JointVector &torque_nm) override;
    JointVector angles_rad() const override;
    JointVector velocities_rad_s() const override;
    double object_rotation_rad() const override;
    Observation observe() const override;
    int substeps_per_step() const override;

  private:
    void restart()
    {
        stage_.reset();
        hand_.reset();
        object_.reset();
        for (auto &constraint : joint_constraints_)
            clear_impulses(*constraint);
        clear_impulses(object_.coulomb_friction());
        stage_ = std::make_unique<Stage>();
        configure_solver();
        stage_->world.setGravity(gravity_palm_m_s2(hand_.model(), setup_.physics));
        add_bodies();
    }

    static void clear_impulses(btMultiBodyConstraint &constraint)
    {
        for (int row = 0; row < constraint.getNumRows(); row++)
            constraint.internalSetAppliedImpulse(row, 0);
    }

    void configure_solver()
    {
        // Bullet keeps this threshold in a global. Contacts are made before they touch, so that a fast
        // tip cannot tunnel.
        gContactBreakingThreshold = setup_.physics.breaking_threshold_m;
        btCollisionDispatcher &dispatcher = stage_->dispatcher;
        dispatcher.setDispatcherFlags(dispatcher.getDispatcherFlags() &
                                      ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
        btContactSolverInfo &info = stage_->world.getSolverInfo();
        info.m_numIterations = setup_.physics.solver_iterations;
        info.m_leastSquaresResidualThreshold = setup_.physics.solver_residual;
        info.m_erp = setup_.physics.error_reduction;
        info.m_erp2 = setup_.physics.error_reduction;
        info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    }

    void add_bodies()
    {
        btMultiBodyDynamicsWorld &world = stage_->world;
        world.addMultiBody(&hand_.body());
        world.addMultiBody(&object_.body());
        for (int i = 0; i < static_cast<int>(hand_.links().size()); i++) {
            const Finger finger = hand_.links()[i].finger;
            btMultiBodyLinkCollider &collider = hand_.collider(i);
            collider.setFriction(1);
            collider.setRestitution(0);
            world.addCollisionObject(&collider, group_of(finger), mask_of(finger, setup_.physics.index_thumb_contact));
        }
        // Bullet multiplies the two friction coefficients of a pair.
        object_.collider().setFriction(setup_.physics.friction);
        object_.collider().setRestitution(0);
        world.addCollisionObject(&object_.collider(), group_object, group_index | group_thumb);
        for (auto &constraint : joint_constraints_)
            world.addMultiBodyConstraint(constraint.get());
        world.addMultiBodyConstraint(&object_.coulomb_friction());
    }

    void make_joint_constraints()
    {
        const double largest_impulse_nms = setup_.hand.torque_limit_nm * substep_s_;
        for (const ArticulatedLink &link : hand_.links()) {
            if (!link.moves) continue;
            const HandLink &model = hand_.model().links[link.model_link];
            joint_constraints_.push_back(std::make_unique<JointStop>(hand_.body(), link.body_link, model.lower_rad,
                                                                     model.upper_rad, setup_.physics.error_reduction));
            const auto &driven = hand_.controlled();
            if (std::find(driven.begin(), driven.end(), link.body_link) != driven.end()) continue;
            auto motor =
                std::make_unique<btMultiBodyJointMotor>(&hand_.body(), link.body_link, 0.0, largest_impulse_nms);
            motor->setPositionTarget(link.held_rad, 0.5);
            motor->setVelocityTarget(0, 1);
            joint_constraints_.push_back(std::move(motor));
        }
        // Bullet would do this at the first step, after an impulse of theirs was asked for.
        for (auto &constraint : joint_constraints_)
            constraint->finalizeMultiDof();
    }

    void sum_contacts(Observation &seen) const
    {
        for (int m = 0; m < stage_->dispatcher.getNumManifolds(); m++) {
            const btPersistentManifold *manifold = stage_->dispatcher.getManifoldByIndexInternal(m);
            const auto *first = btMultiBodyLinkCollider::upcast(manifold->getBody0());
            const auto *second = btMultiBodyLinkCollider::upcast(manifold->getBody1());
            const auto *link = first->m_multiBody == &hand_.body() ? first : second;
            const bool with_object = first->m_multiBody != second->m_multiBody;
            if (!with_object) continue;
            double impulse_ns = 0;
            for (int c = 0; c < manifold->getNumContacts(); c++) {
                impulse_ns += manifold->getContactPoint(c).getAppliedImpulse();
                seen.deepest_m = std::max(seen.deepest_m, -double(manifold->getContactPoint(c).getDistance()));
            }
            const bool index = hand_.finger_of(link->m_link) == Finger::index;
            (index ? seen.index_contact_n : seen.thumb_contact_n) += impulse_ns / substep_s_;
        }
    }

    const settings::Setup setup_;
    const double substep_s_;
    ArticulatedHand hand_;
    const ObjectBody object_shape_;
    HingedObject object_;
    std::vector<std::unique_ptr<btMultiBodyConstraint>> joint_constraints_;
    std::unique_ptr<Stage> stage_;
};

void ReferenceWorld::substep(const JointVector &torque_nm)
{
    btMultiBody &body = hand_.body();
    const double limit_nm = setup_.hand.torque_limit_nm;
    for (std::size_t j = 0; j < joint_count; j++) {
        body.addJointTorque(hand_.controlled()[j], std::clamp(torque_nm[j], -limit_nm, limit_nm));
    }
    object_.apply_viscous_friction();
    stage_->world.stepSimulation(substep_s_, 0);
    hand_.place_colliders();
}

JointVector ReferenceWorld::angles_rad() const
{
    JointVector angle_rad;
    for (std::size_t j = 0; j < joint_count; j++) {
        angle_rad[j] = hand_.body().getJointPos(hand_.controlled()[j]);
    }
    return angle_rad;
}

JointVector ReferenceWorld::velocities_rad_s() const
{
    JointVector velocity_rad_s;
    for (std::size_t j = 0; j < joint_count; j++) {
        velocity_rad_s[j] = hand_.body().getJointVel(hand_.controlled()[j]);
    }
    return velocity_rad_s;
}

double ReferenceWorld::object_rotation_rad() const
{
    return setup_.object.counted_direction * object_.angle_rad();
}

Observation ReferenceWorld::observe() const
{
    Observation seen;
    seen.angle_rad = angles_rad();
    seen.velocity_rad_s = velocities_rad_s();
    seen.p_palm_index_tip_m = hand_.p_palm_tip_m(Finger::index);
    seen.p_palm_thumb_tip_m = hand_.p_palm_tip_m(Finger::thumb);
    seen.object_rad = object_rotation_rad();
    sum_contacts(seen);
    seen.finger_clearance_m = finger_clearance_m(hand_);
    return seen;
}

int ReferenceWorld::substeps_per_step() const
{
    return setup_.physics.substeps;
}

} // namespace

std::unique_ptr<World> make_reference_world(const HandModel &hand, const ObjectSpec &object,
                                            const settings::Setup &setup, HandHold hold)
{
    return std::make_unique<ReferenceWorld>(hand, object, setup, hold);
}

} // namespace twiddle::sim
