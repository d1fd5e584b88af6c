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
// A contact between things that are both held has no inverse mass along its normal; nor has, for all purposes, one
// whose inverse mass is this share of what it would be with nothing held.
constexpr double least_movable_share = 1e-6;

} // namespace

inline ContactVector ContactSolver::Block::velocity(const Velocities &y) const
{
    const FingerVector &finger = y.finger[contact->finger];
    ContactVector u;
    for (int i = 0; i < 3; i++)
        u[i] = contact->finger_row[i][0] * finger[0] + contact->finger_row[i][1] * finger[1] +
               contact->object_row[i] * y.object;
    u[0] -= contact->least_normal_m_s;
    return u;
}

inline double ContactSolver::Block::apply(const ContactVector &change_ns, Velocities &y) const
{
    FingerVector finger{};
    double object = 0;
    for (int i = 0; i < 3; i++) {
        finger[0] += finger_row[i][0] * change_ns[i];
        finger[1] += finger_row[i][1] * change_ns[i];
        object += object_row[i] * change_ns[i];
    }
    y.finger[contact->finger][0] += finger[0];
    y.finger[contact->finger][1] += finger[1];
    y.object += object;
    return std::max({std::abs(finger[0]), std::abs(finger[1]), std::abs(object)});
}

double ContactSolver::Block::relax(Velocities &y) const
{
    ContactVector b = velocity(y);
    const ContactVector before = contact->solution.impulse_ns;
    for (int i = 0; i < 3; i++) {
        const ContactVector &w = law.inverse_mass()[i];
        b[i] -= w[0] * before[0] + w[1] * before[1] + w[2] * before[2];
    }
    const ContactVector after = law.solve(b, contact->solution.multiplier);
    contact->solution.impulse_ns = after;
    return apply({after[0] - before[0], after[1] - before[1], after[2] - before[2]}, y);
}

void ContactSolver::make(Block &block, const Regime &regime) const
{
    const Contact &contact = *block.contact;
    ContactMatrix w;
    for (int i = 0; i < 3; i++) {
        block.finger_row[i] = regime.finger[contact.finger].of(contact.finger_row[i]);
        block.object_row[i] = regime.object_held ? 0 : contact.object_row[i];
        for (int j = 0; j <= i; j++) {
            w[i][j] = w[j][i] = block.finger_row[i][0] * block.finger_row[j][0] +
                                block.finger_row[i][1] * block.finger_row[j][1] +
                                block.object_row[i] * block.object_row[j];
        }
    }
    block.made = true;
    block.movable = w[0][0] > least_movable_share * (contact.finger_row[0][0] * contact.finger_row[0][0] +
                                                     contact.finger_row[0][1] * contact.finger_row[0][1] +
                                                     contact.object_row[0] * contact.object_row[0]);
    if (block.movable) {
        block.law = CoulombContact(w, friction_);
    } else {
        block.contact->solution.impulse_ns = {};
    }
}

void ContactSolver::solve(const Regime &regime, Contacts &contacts, Velocities &velocities)
{
    blocks_.clear();
    for (Contact &contact : contacts) {
        blocks_.add({});
        Block &block = blocks_.last();
        block.contact = &contact;
        if (contact.solution.impulse_ns[0] > 0) {
            make(block, regime);
            if (block.movable) block.apply(contact.solution.impulse_ns, velocities); // the first guess
        }
    }
    for (int sweep = 0; sweep < most_sweeps; sweep++) {
        double change = 0;
        for (Block &block : blocks_) {
            if (!block.made && block.velocity(velocities)[0] < 0) make(block, regime);
            if (block.made && block.movable) change = std::max(change, block.relax(velocities));
        }
        if (blocks_.size() < 2 || change < settled) break;
    }
}

} // namespace twiddle::sim
