#include "contact_solver.hpp"

#include <algorithm>
#include <cmath>

namespace twiddle::sim
{

namespace
{

constexpr int most_sweeps = 30;
// Change of the whitened velocities in a sweep, sqrt(kg) m/s: about 1e-6 m/s of a fingertip.
constexpr double settled = 1e-7;
// Of the changes of one sweep to those of the sweep before, up to which those to come are foreseen.
constexpr double most_ratio = 0.5;
// A contact between things that are both held has no inverse mass along its normal; nor has, for all purposes, one
// whose inverse mass is this share of what it would be with nothing held.
constexpr double least_movable_share = 1e-6;

} // namespace

inline double ContactSolver::Block::normal_velocity(const Velocities &y) const
{
    const FingerVector &finger = y.finger[contact->finger], &row = contact->finger_row[0];
    return row[0] * finger[0] + row[1] * finger[1] + contact->object_row[0] * y.object - contact->least_normal_m_s;
}

inline ContactPair ContactSolver::Block::velocity(const Velocities &y) const
{
    const FingerVector &finger = y.finger[contact->finger];
    return {rows.normal[0] * finger[0] + rows.normal[1] * finger[1] + rows.normal[2] * y.object -
                contact->least_normal_m_s,
            rows.tangential[0] * finger[0] + rows.tangential[1] * finger[1] + rows.tangential[2] * y.object};
}

inline double ContactSolver::Block::apply(const ContactPair &more_ns, Velocities &y) const
{
    std::array<double, 3> change;
    for (int k = 0; k < 3; k++)
        change[k] = acting.normal[k] * more_ns.normal + sum_of_lanes(acting.tangential[k] * more_ns.tangential);
    FingerVector &finger = y.finger[contact->finger];
    finger[0] += change[0];
    finger[1] += change[1];
    y.object += change[2];
    return std::max(std::abs(change[0]), std::max(std::abs(change[1]), std::abs(change[2])));
}

double ContactSolver::Block::relax(Velocities &y)
{
    const ContactPair after = law.solve_along_axes(velocity(y), impulse_ns, contact->solution.multiplier);
    change_ns = {after.normal - impulse_ns.normal, after.tangential - impulse_ns.tangential};
    impulse_ns = after;
    return apply(change_ns, y);
}

inline void ContactSolver::Block::go_on(double share, Velocities &y)
{
    const ContactPair rest_ns = {share * change_ns.normal, share * change_ns.tangential};
    impulse_ns = {impulse_ns.normal + rest_ns.normal, impulse_ns.tangential + rest_ns.tangential};
    apply(rest_ns, y);
}

void ContactSolver::make(Block &block, const Regime &regime) const
{
    const Contact &contact = *block.contact;
    const auto &finger = contact.finger_row;
    const ContactVector &object = contact.object_row;
    // The velocity of an object that is held is 0: its entries have no part in anything.
    const double object_moves = regime.object_held ? 0 : 1;
    block.rows.normal = {finger[0][0], finger[0][1], object_moves * object[0]};
    block.rows.tangential = {Pair{finger[1][0], finger[2][0]}, Pair{finger[1][1], finger[2][1]},
                             object_moves * Pair{object[1], object[2]}};
    block.acting = block.rows;
    const auto &n = block.rows.normal;
    const auto &t = block.rows.tangential;
    const Freedom &freedom = regime.finger[contact.finger];
    if (!freedom.of_all()) {
        const FingerVector moving = freedom.of({n[0], n[1]});
        block.acting.normal = {moving[0], moving[1], n[2]};
        block.acting.tangential = {freedom.p00 * t[0] + freedom.p01 * t[1], freedom.p01 * t[0] + freedom.p11 * t[1],
                                   t[2]};
    }
    InverseMass w;
    for (int k = 0; k < 3; k++) {
        const double normal = block.acting.normal[k];
        const Pair tangential = block.acting.tangential[k];
        w.normal += normal * normal;
        w.coupled += normal * tangential;
        w.tangential += tangential * tangential;
        w.across += tangential[0] * tangential[1];
    }
    block.made = true;
    block.movable =
        w.normal > least_movable_share * (n[0] * n[0] + n[1] * n[1] + contact.object_row[0] * contact.object_row[0]);
    block.impulse_ns = {};
    if (!block.movable) return;
    block.law = CoulombContact(w, friction_);
    for (Pair &row : block.acting.tangential)
        row = block.law.to_axes(row);
    if (freedom.of_all()) {
        block.rows.tangential = block.acting.tangential;
    } else {
        for (Pair &row : block.rows.tangential)
            row = block.law.to_axes(row);
    }
}

inline void ContactSolver::Block::store() const
{
    const Pair tangential = law.from_axes(impulse_ns.tangential);
    contact->solution.impulse_ns = {impulse_ns.normal, tangential[0], tangential[1]};
}

void ContactSolver::solve_alone(const Regime &regime, Contact &contact, Velocities &velocities)
{
    blocks_.clear();
    Block &block = blocks_.add();
    block.contact = &contact;
    if (block.normal_velocity(velocities) < 0) {
        make(block, regime);
        if (block.movable) block.relax(velocities);
        block.store();
    } else {
        contact.solution.impulse_ns = {};
    }
}

void ContactSolver::solve(const Regime &regime, Contacts &contacts, Velocities &velocities)
{
    if (contacts.size() == 0) return;
    if (contacts.size() == 1) {
        solve_alone(regime, contacts[0], velocities);
        return;
    }
    blocks_.clear();
    std::array<int, 2> on_finger{};
    for (Contact &contact : contacts) {
        Block &block = blocks_.add();
        block.contact = &contact;
        block.made = false;
        on_finger[contact.finger]++;
        if (contact.solution.impulse_ns[0] > 0) {
            make(block, regime);
            if (!block.movable) continue;
            const ContactVector &guess_ns = contact.solution.impulse_ns;
            block.impulse_ns = {guess_ns[0], block.law.to_axes(Pair{guess_ns[1], guess_ns[2]})};
            block.apply(block.impulse_ns, velocities);
        }
    }
    // Contacts of different fingers do not feel each other through an object that is held.
    const bool one_sweep = regime.object_held && on_finger[0] < 2 && on_finger[1] < 2;
    Coupling last;
    for (int sweep = 0; sweep < most_sweeps; sweep++) {
        const Coupling now = relax_all(regime, velocities);
        if (one_sweep || now.change < settled) break;
        const double ratio = now.of_two_fingers && last.of_two_fingers ? now.object_change / last.object_change : 1;
        last = now;
        if (std::abs(ratio) > most_ratio) continue;
        const double share = ratio / (1 - ratio);
        if (std::abs(share) * now.change < settled) break; // all that is to come
        for (Block &block : blocks_)
            if (block.made && block.movable) block.go_on(share, velocities);
        last = {};
    }
    for (const Block &block : blocks_) {
        if (block.made) block.store();
    }
}

ContactSolver::Coupling ContactSolver::relax_all(const Regime &regime, Velocities &velocities)
{
    Coupling coupling;
    int relaxed = 0, finger = 0;
    for (Block &block : blocks_) {
        if (!block.made && block.normal_velocity(velocities) < 0) make(block, regime);
        if (!block.made || !block.movable) continue;
        const double object_before = velocities.object;
        coupling.change = std::max(coupling.change, block.relax(velocities));
        coupling.object_change = velocities.object - object_before;
        coupling.of_two_fingers = ++relaxed == 2 && block.contact->finger != finger;
        finger = block.contact->finger;
    }
    return coupling;
}

} // namespace twiddle::sim
