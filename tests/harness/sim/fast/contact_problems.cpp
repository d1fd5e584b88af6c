#include "contact_problems.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twiddle::sim
{

namespace
{

constexpr double least_inverse_mass = 1e-9; // 1/kg, as contact_solver.cpp has it; a finger's is about 100

// Of a contact's impulse, what the law's own solution may miss of the cone, as a share of the impulse that would stop
// the contact without friction (coulomb_contact.hpp).
constexpr double cone_share = 2e-10;

// Relative rounding error of the tangential impulse. Where two joints and a hinge, or what of them moves, cannot move
// a contact in all directions, W is singular but for the share 1e-12 that coulomb_contact.cpp adds, and digits are
// lost in that ratio.
double rounding_share(const ContactMatrix &w, double multiplier)
{
    const double a11 = w[1][1] - w[0][1] * w[0][1] / w[0][0], a12 = w[1][2] - w[0][1] * w[0][2] / w[0][0],
                 a22 = w[2][2] - w[0][2] * w[0][2] / w[0][0];
    const double trace = a11 + a22, smallest = std::max(a11 * a22 - a12 * a12, 0.0) / trace;
    const double least = 1e-12 * std::max({w[0][0], w[1][1], w[2][2]});
    return 4 * std::numeric_limits<double>::epsilon() * trace / (smallest + multiplier + least);
}

} // namespace

ProblemSource::ProblemSource(unsigned seed)
    : random_(seed), finger_{BulletFinger(default_setup(), Finger::index),
                             BulletFinger(default_setup(), Finger::thumb)},
      dynamics_{FingerDynamics(finger_[0].hand, finger_[0].link[0], finger_[0].link[1], finger_[0].gravity_m_s2),
                FingerDynamics(finger_[1].hand, finger_[1].link[0], finger_[1].link[1], finger_[1].gravity_m_s2)},
      kinematics_{
          FingerKinematics(finger_[0].hand, finger_[0].link[0], finger_[0].link[1], btVector3(0.040, 0.001, 0.054)),
          FingerKinematics(finger_[1].hand, finger_[1].link[0], finger_[1].link[1], btVector3(0.040, 0.001, 0.054))}
{
}

std::array<JointStops, 2> ProblemSource::stops() const
{
    return {JointStops(finger_[0].lower_rad, finger_[0].upper_rad, error_reduction, substep_s),
            JointStops(finger_[1].lower_rad, finger_[1].upper_rad, error_reduction, substep_s)};
}

btVector3 ProblemSource::random_direction()
{
    std::normal_distribution<double> normal;
    const double x = normal(random_), y = normal(random_);
    return btVector3(x, y, normal(random_)).normalized();
}

FingerVector ProblemSource::angles_at_stops_rad(int f)
{
    FingerVector angle_rad;
    for (int j = 0; j < 2; j++) {
        const double off_rad = uniform(-0.01, 0.02); // past the stop, or before it
        const bool lower = uniform(0, 1) < 0.5;
        angle_rad[j] = lower ? finger_[f].lower_rad[j] + off_rad : finger_[f].upper_rad[j] - off_rad;
    }
    return angle_rad;
}

ContactProblem ProblemSource::problem(Places places, int contacts)
{
    const FingerVector index_rad = finger_[0].random_angles(random_, 0);
    return problem(places, contacts, {index_rad, finger_[1].random_angles(random_, 0)});
}

ContactProblem ProblemSource::problem_at_stops(Places places, int contacts)
{
    const FingerVector index_rad = angles_at_stops_rad(0);
    return problem(places, contacts, {index_rad, angles_at_stops_rad(1)});
}

ContactProblem ProblemSource::problem(Places places, int contacts, const std::array<FingerVector, 2> &angle_rad)
{
    ContactProblem problem;
    problem.friction = uniform(0.1, 1);
    for (int f = 0; f < 2; f++) {
        FingerState &state = problem.state[f];
        state.angle_rad = angle_rad[f];
        const std::array<SineCosine, 2> angle = sines_cosines(angle_rad[f]);
        const FingerVector velocity_rad_s = random_pair(random_, 5), torque_nm = random_pair(random_, 0.3);
        const FingerEquations equations = dynamics_[f].equations(angle, velocity_rad_s);
        state.mass = equations.mass;
        const FingerVector before = state.mass.from_velocity(velocity_rad_s);
        const FingerVector change = state.mass.whitened({substep_s * (torque_nm[0] - equations.resistance_nm[0]),
                                                         substep_s * (torque_nm[1] - equations.resistance_nm[1])});
        problem.free.finger[f] = {before[0] + change[0], before[1] + change[1]};
    }
    problem.free.object = std::sqrt(object_inertia_kg_m2) * uniform(-5, 5);

    const bool flat = places == Places::face;
    std::array<btVector3, 2> normal;
    std::array<int, 2> joint;
    std::array<std::size_t, 2> capsule;
    const auto choose_place = [&](int f) {
        normal[f] = random_direction();
        joint[f] = uniform(0, 1) < 0.2 ? 0 : 1;
        const auto &capsules = kinematics_[f].carried(joint[f]).capsules;
        capsule[f] = std::uniform_int_distribution<std::size_t>(0, capsules.size() - 1)(random_);
    };
    choose_place(0);
    choose_place(1);
    for (int i = 0; i < contacts; i++) {
        const int f = uniform(0, 1) < 0.5 ? 0 : 1;
        if (!flat) choose_place(f);
        const btVector3 tilted = (normal[f] + (flat ? 0.05 : 0) * random_direction()).normalized();
        add_contact(problem, f, joint[f], capsule[f], uniform(0, 1), tilted);
    }
    return problem;
}

void ProblemSource::add_contact(ContactProblem &problem, int finger, int joint, std::size_t capsule, double share,
                                const btVector3 &normal)
{
    const FingerState &state = problem.state[finger];
    const std::array<Frame, 2> frame = kinematics_[finger].frames(sines_cosines(state.angle_rad));
    const CarriedCapsules &carried = kinematics_[finger].carried(joint);
    const LinkCapsule &link = carried.capsules[capsule];
    const btVector3 p_joint_m = carried.points_m[link.start].lerp(carried.points_m[link.end], share);
    const btVector3 p_finger_m = frame[joint].point(p_joint_m) - link.radius_m * normal;
    // A place on an object of 32 mm radius whose surface is not quite round.
    const btVector3 p_object_m = 0.032 * normal + uniform(0, 0.01) * random_direction();
    const btVector3 by_first = frame[0].z.cross(p_finger_m - frame[0].origin_m);
    const btVector3 by_second = joint == 0 ? btVector3(0, 0, 0) : frame[1].z.cross(p_finger_m - frame[1].origin_m);
    const btVector3 by_hinge = btVector3(0, 0, 1).cross(p_object_m);

    btVector3 across, along;
    btPlaneSpace1(normal, across, along);
    Contact contact;
    contact.finger = finger;
    const std::array<btVector3, 3> direction = {normal, across, along};
    for (int i = 0; i < 3; i++) {
        contact.finger_row[i] = state.mass.whitened({direction[i].dot(by_first), direction[i].dot(by_second)});
        contact.object_row[i] = -direction[i].dot(by_hinge) / std::sqrt(object_inertia_kg_m2);
    }
    contact.distance_m = uniform(0, 1) < 0.5 ? 0 : uniform(0, 0.0005);
    contact.least_normal_m_s = -contact.distance_m / substep_s;
    problem.contacts.add(contact);
}

BothFingers in_lanes(const std::array<FingerState, 2> &state)
{
    BothFingers both;
    both.mass.coupling = Pair{state[0].mass.coupling, state[1].mass.coupling};
    for (int j = 0; j < 2; j++) {
        both.angle_rad[j] = Pair{state[0].angle_rad[j], state[1].angle_rad[j]};
        both.mass.root[j] = Pair{state[0].mass.root[j], state[1].mass.root[j]};
        both.mass.inverse_root[j] = Pair{state[0].mass.inverse_root[j], state[1].mass.inverse_root[j]};
    }
    return both;
}

ContactVector contact_velocity(const Contact &contact, const Velocities &velocities)
{
    const FingerVector &finger = velocities.finger[contact.finger];
    ContactVector u;
    for (int i = 0; i < 3; i++)
        u[i] = contact.finger_row[i][0] * finger[0] + contact.finger_row[i][1] * finger[1] +
               contact.object_row[i] * velocities.object;
    u[0] -= contact.least_normal_m_s;
    return u;
}

Velocities change_by(const Contacts &contacts, const Regime &regime)
{
    Velocities change;
    for (const Contact &contact : contacts) {
        for (int i = 0; i < 3; i++) {
            const FingerVector row = regime.finger[contact.finger].of(contact.finger_row[i]);
            change.finger[contact.finger][0] += row[0] * contact.solution.impulse_ns[i];
            change.finger[contact.finger][1] += row[1] * contact.solution.impulse_ns[i];
            if (!regime.object_held) change.object += contact.object_row[i] * contact.solution.impulse_ns[i];
        }
    }
    return change;
}

ContactMatrix inverse_mass(const Contact &contact, const Regime &regime)
{
    ContactMatrix w;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const FingerVector a = contact.finger_row[i], b = regime.finger[contact.finger].of(contact.finger_row[j]);
            const double by_object = contact.object_row[i] * contact.object_row[j];
            w[i][j] = a[0] * b[0] + a[1] * b[1] + (regime.object_held ? 0 : by_object);
        }
    }
    return w;
}

bool can_move(const Contact &contact, const Regime &regime)
{
    return inverse_mass(contact, regime)[0][0] > least_inverse_mass;
}

bool has_one_answer(const Contact &contact, const Regime &regime, double friction)
{
    const ContactMatrix w = inverse_mass(contact, regime);
    return w[0][0] > friction * std::hypot(w[0][1], w[0][2]);
}

bool each_has_one_answer(const ContactProblem &problem, const Regime &regime)
{
    for (const Contact &contact : problem.contacts)
        if (can_move(contact, regime) && !has_one_answer(contact, regime, problem.friction)) return false;
    return true;
}

std::string broken_law(const Contact &contact, const Regime &regime, const Velocities &velocities, double friction,
                       double tolerance)
{
    const ContactVector &p = contact.solution.impulse_ns;
    if (!can_move(contact, regime)) return p == ContactVector{} ? "" : "an impulse on what cannot move";
    const ContactVector u = contact_velocity(contact, velocities);
    ContactVector off_m_s; // by how much u may be wrong
    for (int i = 0; i < 3; i++)
        off_m_s[i] = tolerance * (std::abs(contact.finger_row[i][0]) + std::abs(contact.finger_row[i][1]) +
                                  std::abs(contact.object_row[i]));
    const ContactMatrix w = inverse_mass(contact, regime);
    const double alone_ns =
        (std::abs(u[0]) + std::abs(w[0][0] * p[0]) + std::abs(w[0][1] * p[1]) + std::abs(w[0][2] * p[2])) / w[0][0];
    const double tangential_ns = std::hypot(p[1], p[2]), slip_m_s = std::hypot(u[1], u[2]);
    const double rounding_ns = rounding_share(w, contact.solution.multiplier) * tangential_ns;
    const double cone_ns = cone_share * alone_ns + rounding_ns;

    if (p[0] < 0) return "pull";
    if (u[0] < -off_m_s[0]) return "approach";
    if (tangential_ns > friction * p[0] + cone_ns) return "cone";
    if (p[0] > 0 && u[0] > off_m_s[0]) return "push without touch";
    // Most dissipation: where there is slip, the tangential impulse is mu p_n against it. The sum is 0 then, and by the
    // cone never below.
    const double not_dissipated = p[1] * u[1] + p[2] * u[2] + friction * p[0] * slip_m_s;
    const double off_tangential_m_s = std::hypot(off_m_s[1], off_m_s[2]) + (w[1][1] + w[2][2]) * rounding_ns;
    if (not_dissipated > 2 * friction * p[0] * off_tangential_m_s + cone_ns * slip_m_s) return "dissipation";
    return "";
}

double largest_difference(const Velocities &a, const Velocities &b)
{
    double largest = std::abs(a.object - b.object);
    for (int f = 0; f < 2; f++)
        for (int j = 0; j < 2; j++)
            largest = std::max(largest, std::abs(a.finger[f][j] - b.finger[f][j]));
    return largest;
}

double largest_entry(const Velocities &velocities)
{
    return largest_difference(velocities, {});
}

void add(Velocities &velocities, const Velocities &change)
{
    for (int f = 0; f < 2; f++)
        for (int j = 0; j < 2; j++)
            velocities.finger[f][j] += change.finger[f][j];
    velocities.object += change.object;
}

bool has_settled(const ContactProblem &problem, const Regime &regime, const Velocities &found)
{
    Velocities velocities = found;
    for (const Contact &contact : problem.contacts) {
        if (!can_move(contact, regime)) continue;
        const ContactMatrix w = inverse_mass(contact, regime);
        ContactVector b = contact_velocity(contact, velocities);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                b[i] -= w[i][j] * contact.solution.impulse_ns[j];
        const ContactVector after = CoulombContact(w, problem.friction).solve(b);
        Contacts step;
        step.add(contact);
        for (int i = 0; i < 3; i++)
            step.last().solution.impulse_ns[i] -= after[i];
        const Velocities change = change_by(step, regime);
        if (largest_entry(change) > settled) return false;
        for (int f = 0; f < 2; f++)
            for (int j = 0; j < 2; j++)
                velocities.finger[f][j] -= change.finger[f][j];
        velocities.object -= change.object;
    }
    return true;
}

} // namespace twiddle::sim
