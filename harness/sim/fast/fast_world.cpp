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

// One finger's part of the model.
struct FingerModel {
    std::array<std::size_t, 2> joint; // its places in joint arrays, from the palm outwards
    FingerDynamics dynamics;
    FingerKinematics kinematics;
};

// How a contact was solved: the first guess of the next substep.
struct RememberedContact {
    int finger = 0;
    int feature = 0;
    ContactSolution solution;
};

[[noreturn]] void refuse(const std::string &what)
{
    throw NotCovered("the fast stepper does not cover " + what + "; use --stepper reference");
}

void require_coverage(const HandHold hold, const settings::PhysicsSetup &setup)
{
    if (hold != HandHold::welded) refuse("--hand full");
    if (setup.index_thumb_contact) refuse("contact between the fingers ([contact] index_thumb_contact)");
}

FingerModel finger_model(ArticulatedHand &hand, Joint first, Joint second, const settings::PhysicsSetup &physics,
                         const btVector3 &p_palm_centre_m)
{
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
    const FingerKinematics kinematics(hand, first_link, second_link, p_palm_centre_m);
    for (const int joint : {0, 1}) {
        if (kinematics.carried(joint).capsules.size() > most_capsules)
            refuse("a hand with more than " + std::to_string(most_capsules) + " rigid links on one joint");
    }
    return {{first, second},
            FingerDynamics(hand, first_link, second_link, gravity_palm_m_s2(hand.model(), physics)),
            kinematics};
}

JointStops joint_stops(const HandModel &model, const std::array<std::size_t, 2> &joint, double error_reduction,
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
        return angle_rad_;
    }
    JointVector velocities_rad_s() const override
    {
        return velocity_rad_s_;
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
    // The velocities after the substep if nothing touched; fills state_.
    Velocities free_velocities(const JointVector &torque_nm);
    void find_contacts(const Velocities &free);
    void integrate(const Velocities &velocities);

    const settings::Setup setup_;
    const double substep_s_;
    const ObjectBody object_;
    mutable ArticulatedHand hand_; // the source of all constants, and the body that observe() poses
    const std::array<FingerModel, 2> fingers_;
    const ContactFinder finder_;
    ConstraintSearch search_;

    JointVector angle_rad_{}, velocity_rad_s_{};
    double object_rad_ = 0, object_rad_s_ = 0;
    // How the last substep was solved: where the next one starts.
    Holds holds_;
    Contacts contacts_;

    // What a substep works with.
    std::array<FingerState, 2> state_;
    ShortList<RememberedContact, most_contacts> remembered_; // of the last substep
};

FastWorld::FastWorld(const HandModel &model, const ObjectSpec &spec, const settings::Setup &setup)
    : setup_(setup), substep_s_(control_step_s / setup.physics.substeps), object_(object_body(spec, setup.object)),
      hand_(model, setup.hand, HandHold::welded), fingers_{finger_model(hand_, aai, fei, setup.physics,
                                                                        object_.p_palm_centre_m),
                                                           finger_model(hand_, ot, fet, setup.physics,
                                                                        object_.p_palm_centre_m)},
      finder_({fingers_[0].kinematics, fingers_[1].kinematics}, object_, setup.physics.breaking_threshold_m,
              setup.physics.error_reduction, substep_s_),
      search_(ContactSolver(setup.physics.friction),
              HingeFriction(setup.object.coulomb_nm, object_.inertia_kg_m2, substep_s_),
              {joint_stops(model, fingers_[0].joint, setup.physics.error_reduction, substep_s_),
               joint_stops(model, fingers_[1].joint, setup.physics.error_reduction, substep_s_)})
{
    require_clearance(hand_, object_, spec.name);
    restart();
}

void FastWorld::restart()
{
    angle_rad_ = velocity_rad_s_ = {};
    object_rad_ = object_rad_s_ = 0;
    holds_ = {};
    contacts_.clear();
}

void FastWorld::substep(const JointVector &torque_nm)
{
    const Velocities free = free_velocities(torque_nm);
    find_contacts(free);
    const Velocities velocities = search_.solve(state_, free, contacts_, holds_);
    integrate(velocities);
}

Velocities FastWorld::free_velocities(const JointVector &torque_nm)
{
    Velocities free;
    const double limit_nm = setup_.hand.torque_limit_nm;
    for (int f = 0; f < 2; f++) {
        const FingerModel &finger = fingers_[f];
        FingerState &state = state_[f];
        FingerVector velocity_rad_s, impulse_nms;
        for (int j = 0; j < 2; j++) {
            state.angle_rad[j] = angle_rad_[finger.joint[j]];
            state.angle[j] = sine_cosine(state.angle_rad[j]);
            velocity_rad_s[j] = velocity_rad_s_[finger.joint[j]];
        }
        const FingerEquations equations = finger.dynamics.equations(state.angle, velocity_rad_s);
        state.mass = equations.mass;
        for (int j = 0; j < 2; j++) {
            const double driven_nm = std::clamp(torque_nm[finger.joint[j]], -limit_nm, limit_nm);
            impulse_nms[j] = substep_s_ * (driven_nm - equations.resistance_nm[j]);
        }
        const FingerVector before = state.mass.from_velocity(velocity_rad_s);
        const FingerVector change = state.mass.whitened(impulse_nms);
        free.finger[f] = {before[0] + change[0], before[1] + change[1]};
    }
    const double viscous_nm = -setup_.object.viscous_nms_per_rad * object_rad_s_;
    free.object = finder_.whitening() * (object_rad_s_ + substep_s_ * viscous_nm / object_.inertia_kg_m2);
    return free;
}

void FastWorld::find_contacts(const Velocities &free)
{
    remembered_.clear();
    for (const Contact &contact : contacts_)
        remembered_.add({contact.finger, contact.feature, contact.solution});
    finder_.find(state_, object_rad_, free, contacts_);
    for (Contact &contact : contacts_) {
        for (const RememberedContact &before : remembered_) {
            if (before.finger == contact.finger && before.feature == contact.feature)
                contact.solution = before.solution;
        }
    }
}

void FastWorld::integrate(const Velocities &velocities)
{
    for (int f = 0; f < 2; f++) {
        const FingerVector velocity_rad_s = state_[f].mass.velocity(velocities.finger[f]);
        for (int j = 0; j < 2; j++) {
            velocity_rad_s_[fingers_[f].joint[j]] = velocity_rad_s[j];
            angle_rad_[fingers_[f].joint[j]] += substep_s_ * velocity_rad_s[j];
        }
    }
    object_rad_s_ = velocities.object / finder_.whitening();
    object_rad_ += substep_s_ * object_rad_s_;
}

Observation FastWorld::observe() const
{
    std::vector<double> posture_rad(joint_count);
    for (std::size_t j = 0; j < joint_count; j++)
        posture_rad[hand_.controlled()[j]] = angle_rad_[j];
    hand_.set_posture(posture_rad);

    Observation seen;
    seen.angle_rad = angle_rad_;
    seen.velocity_rad_s = velocity_rad_s_;
    seen.p_palm_index_tip_m = hand_.p_palm_tip_m(Finger::index);
    seen.p_palm_thumb_tip_m = hand_.p_palm_tip_m(Finger::thumb);
    seen.object_rad = object_rotation_rad();
    for (const Contact &contact : contacts_) {
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
