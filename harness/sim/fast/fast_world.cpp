#include "fast_world.hpp"

#include "constraint_search.hpp"
#include "contact_finder.hpp"
#include "finger_dynamics.hpp"
#include "finger_kinematics.hpp"
#include "settings/constants.hpp"
#include "sim/clearance.hpp"
#include "sim/object_body.hpp"

#include <algorithm>

namespace twiddle::sim
{

namespace
{

// The joints of index and thumb, from the palm outwards. The index is lane 0 of all pairs, the thumb lane 1.
constexpr std::array<std::array<Joint, 2>, 2> finger_joints = {{{aai, fei}, {ot, fet}}};

// One finger's part of the model.
struct FingerModel {
    FingerDynamics dynamics;
    FingerKinematics kinematics;
};

// A value of each joint, in lanes, and back.
FingerVectorOf<Pair> lanes_of(const JointVector &value)
{
    return {Pair{value[aai], value[ot]}, Pair{value[fei], value[fet]}};
}

JointVector of_joints(const FingerVectorOf<Pair> &lanes)
{
    JointVector value;
    for (int f = 0; f < 2; f++)
        for (int j = 0; j < 2; j++)
            value[finger_joints[f][j]] = lanes[j][f];
    return value;
}

[[noreturn]] void refuse(const std::string &what)
{
    throw NotCovered("the fast stepper does not cover " + what + "; use --stepper reference");
}

void require_coverage(const HandHold hold, const settings::PhysicsSetup &setup)
{
    if (hold != HandHold::welded) refuse("--hand full");
    if (setup.index_thumb_contact) refuse("contact between the fingers ([contact] index_thumb_contact)");
}

FingerModel finger_model(ArticulatedHand &hand, const std::array<Joint, 2> &joint,
                         const settings::PhysicsSetup &physics, const btVector3 &p_palm_centre_m)
{
    const auto [first, second] = joint;
    const int first_link = hand.controlled()[first], second_link = hand.controlled()[second];
    const auto turns = [&hand](int link) {
        return hand.body().getLink(link).m_jointType == btMultibodyLink::eRevolute;
    };
    if (!turns(first_link) || !turns(second_link))
        refuse(std::string("a hand whose joint ") + joint_urdf_names[first] + " or " + joint_urdf_names[second] +
               " does not turn");
    if (hand.body().getParent(first_link) != -1 || hand.body().getParent(second_link) != first_link)
        refuse(std::string("a hand whose joint ") + joint_urdf_names[second] + " does not hang on " +
               joint_urdf_names[first] + ", and that on the palm");
    return {FingerDynamics(hand, first_link, second_link, gravity_palm_m_s2(hand.model(), physics)),
            FingerKinematics(hand, first_link, second_link, p_palm_centre_m)};
}

JointStops joint_stops(const HandModel &model, const std::array<Joint, 2> &joint, double error_reduction,
                       double substep_s)
{
    FingerVector lower_rad, upper_rad;
    for (int j = 0; j < 2; j++) {
        const HandLink &link = model.links[model.link_of_joint(joint_urdf_names[joint[j]])];
        lower_rad[j] = link.lower_rad;
        upper_rad[j] = link.upper_rad;
    }
    return JointStops(lower_rad, upper_rad, error_reduction, substep_s);
}

class FastWorld final : public World
{
  public:
    FastWorld(const HandModel &model, const ObjectSpec &spec, const settings::Setup &setup);

    void reset() override
    {
        restart();
    }
    void substep(const JointVector &torque_nm) override;
    JointVector angles_rad() const override
    {
        return of_joints(angle_rad_);
    }
    JointVector velocities_rad_s() const override
    {
        return of_joints(velocity_rad_s_);
    }
    double object_rotation_rad() const override
    {
        return setup_.object.counted_direction * object_rad_;
    }
    Observation observe() const override;
    int substeps_per_step() const override
    {
        return setup_.physics.substeps;
    }

  private:
    void restart();
    // Fill motion_ and state_, and return the velocities after the substep if nothing touched.
    Velocities free_velocities(const JointVector &torque_nm);
    void find_contacts(const Velocities &free);
    void integrate(const Velocities &velocities);

    Contacts &contacts()
    {
        return contacts_[present_];
    }
    const Contacts &contacts() const
    {
        return contacts_[present_];
    }

    const settings::Setup setup_;
    const double substep_s_;
    const ObjectBody object_;
    mutable ArticulatedHand hand_; // the source of all constants, and the body that observe() poses
    const std::array<FingerModel, 2> fingers_;
    const FingerConstants<Pair> dynamics_;
    ContactFinder finder_;
    ConstraintSearch search_;

    FingerVectorOf<Pair> angle_rad_{}, velocity_rad_s_{};
    double object_rad_ = 0, object_rad_s_ = 0;
    // How the last substep was solved: where the next one starts.
    Holds holds_;
    // Of the last substep and of the one before.
    std::array<Contacts, 2> contacts_;
    int present_ = 0;

    // What a substep works with.
    Motion motion_;
    BothFingers state_;
};

FastWorld::FastWorld(const HandModel &model, const ObjectSpec &spec, const settings::Setup &setup)
    : setup_(setup), substep_s_(control_step_s / setup.physics.substeps), object_(object_body(spec, setup.object)),
      hand_(model, setup.hand, HandHold::welded), fingers_{finger_model(hand_, finger_joints[0], setup.physics,
                                                                        object_.p_palm_centre_m),
                                                           finger_model(hand_, finger_joints[1], setup.physics,
                                                                        object_.p_palm_centre_m)},
      dynamics_(in_lanes(fingers_[0].dynamics.constants(), fingers_[1].dynamics.constants())),
      finder_({fingers_[0].kinematics, fingers_[1].kinematics}, object_, setup.physics.breaking_threshold_m,
              setup.physics.error_reduction, substep_s_),
      search_(ContactSolver(setup.physics.friction),
              HingeFriction(setup.object.coulomb_nm, object_.inertia_kg_m2, substep_s_),
              {joint_stops(model, finger_joints[0], setup.physics.error_reduction, substep_s_),
               joint_stops(model, finger_joints[1], setup.physics.error_reduction, substep_s_)},
              substep_s_)
{
    require_clearance(hand_, object_, spec.name);
    restart();
}

void FastWorld::restart()
{
    angle_rad_ = velocity_rad_s_ = {};
    object_rad_ = object_rad_s_ = 0;
    holds_ = {};
    contacts().clear();
    finder_.reset();
}

void FastWorld::substep(const JointVector &torque_nm)
{
    const Velocities free = free_velocities(torque_nm);
    find_contacts(free);
    const Velocities velocities = search_.solve(state_, free, contacts(), holds_);
    integrate(velocities);
}

Velocities FastWorld::free_velocities(const JointVector &torque_nm)
{
    motion_.angle = {sine_cosine(angle_rad_[0]), sine_cosine(angle_rad_[1])};
    const FingerEquationsOf<Pair> equations = dynamics_.equations(motion_.angle, velocity_rad_s_);
    const MassFactorOf<Pair> &mass = equations.mass;
    state_ = {angle_rad_, mass};

    JointVector driven_nm;
    const double limit_nm = setup_.hand.torque_limit_nm;
    for (std::size_t j = 0; j < joint_count; j++)
        driven_nm[j] = std::min(std::max(torque_nm[j], -limit_nm), limit_nm);
    FingerVectorOf<Pair> impulse_nms = lanes_of(driven_nm);
    for (int j = 0; j < 2; j++)
        impulse_nms[j] = substep_s_ * (impulse_nms[j] - equations.resistance_nm[j]);
    const FingerVectorOf<Pair> before = mass.from_velocity(velocity_rad_s_), change = mass.whitened(impulse_nms);
    const FingerVectorOf<Pair> after = {before[0] + change[0], before[1] + change[1]};
    motion_.velocity_rad_s = velocity_rad_s_;
    motion_.free_velocity_rad_s = mass.velocity(after);
    motion_.object_rad = object_rad_;
    motion_.object_rad_s = object_rad_s_;

    Velocities free;
    for (int f = 0; f < 2; f++)
        free.finger[f] = {after[0][f], after[1][f]};
    const double viscous_nm = -setup_.object.viscous_nms_per_rad * object_rad_s_;
    free.object = finder_.whitening() * (object_rad_s_ + substep_s_ * viscous_nm / object_.inertia_kg_m2);
    return free;
}

void FastWorld::find_contacts(const Velocities &free)
{
    const Contacts &last = contacts();
    present_ = 1 - present_;
    finder_.find(motion_, state_.mass, free, contacts());
    for (Contact &contact : contacts()) {
        for (const Contact &before : last) {
            if (before.finger == contact.finger && before.feature == contact.feature)
                contact.solution = before.solution;
        }
    }
}

void FastWorld::integrate(const Velocities &velocities)
{
    velocity_rad_s_ = state_.mass.velocity(in_lanes(velocities.finger));
    for (int j = 0; j < 2; j++)
        angle_rad_[j] += substep_s_ * velocity_rad_s_[j];
    object_rad_s_ = velocities.object / finder_.whitening();
    object_rad_ += substep_s_ * object_rad_s_;
}

Observation FastWorld::observe() const
{
    Observation seen;
    seen.angle_rad = angles_rad();
    seen.velocity_rad_s = velocities_rad_s();
    std::vector<double> posture_rad(joint_count);
    for (std::size_t j = 0; j < joint_count; j++)
        posture_rad[hand_.controlled()[j]] = seen.angle_rad[j];
    hand_.set_posture(posture_rad);

    seen.p_palm_index_tip_m = hand_.p_palm_tip_m(Finger::index);
    seen.p_palm_thumb_tip_m = hand_.p_palm_tip_m(Finger::thumb);
    seen.object_rad = object_rotation_rad();
    for (const Contact &contact : contacts()) {
        (contact.finger == 0 ? seen.index_contact_n : seen.thumb_contact_n) +=
            contact.solution.impulse_ns[0] / substep_s_;
        seen.deepest_m = std::max(seen.deepest_m, -contact.distance_m);
    }
    seen.finger_clearance_m = finger_clearance_m(hand_);
    return seen;
}

} // namespace

std::unique_ptr<World> make_fast_world(const HandModel &hand, const ObjectSpec &object, const settings::Setup &setup,
                                       HandHold hold)
{
    require_coverage(hold, setup.physics);
    return std::make_unique<FastWorld>(hand, object, setup);
}

} // namespace twiddle::sim
