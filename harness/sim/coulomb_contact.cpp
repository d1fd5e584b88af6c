#include "coulomb_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twiddle::sim
{

namespace
{

// A direction in which neither body can move has no inverse mass; this share of the largest keeps it solvable.
constexpr double least_share = 1e-12;
constexpr int most_steps = 60;
constexpr double tolerance = 1e-10;

// The next multiplier where Newton's step leaves the bracket: 0 if that is not known to be too small (low < 0), else
// one between them in magnitude, since a multiplier can have any.
double between(double low, double high, double scale)
{
    if (low < 0) return 0;
    if (high == std::numeric_limits<double>::infinity()) return 4 * low + scale;
    return low > 0 ? std::sqrt(low * high) : high / 1000;
}

} // namespace

CoulombContact::CoulombContact(const ContactMatrix &inverse_mass, double friction)
    : inverse_mass_(inverse_mass), friction_(friction), inverse_normal_(1 / inverse_mass[0][0])
{
    const ContactMatrix &w = inverse_mass_;
    coupling_ = {w[0][1] * inverse_normal_, w[0][2] * inverse_normal_};
    const double least = least_share * std::max({w[0][0], w[1][1], w[2][2]});
    schur_ = {w[1][1] - w[0][1] * coupling_[0] + least, w[1][2] - w[0][1] * coupling_[1],
              w[2][2] - w[0][2] * coupling_[1] + least};
}

inline CoulombContact::Trial CoulombContact::try_multiplier(double lambda, double normal_alone,
                                                            const std::array<double, 2> &c) const
{
    const double a11 = schur_[0] + lambda, a12 = schur_[1], a22 = schur_[2] + lambda;
    const double inverse_determinant = 1 / (a11 * a22 - a12 * a12);
    const auto solve = [&](double x, double y) {
        return std::array<double, 2>{(a22 * x - a12 * y) * inverse_determinant,
                                     (a11 * y - a12 * x) * inverse_determinant};
    };
    Trial trial;
    trial.tangential = solve(-c[0], -c[1]);
    trial.solved = solve(trial.tangential[0], trial.tangential[1]);
    trial.normal = normal_alone - coupling_[0] * trial.tangential[0] - coupling_[1] * trial.tangential[1];
    trial.size = std::sqrt(trial.tangential[0] * trial.tangential[0] + trial.tangential[1] * trial.tangential[1]);
    return trial;
}

inline double CoulombContact::newton_step(const Trial &trial) const
{
    // Of f = mu p_n / |p_t| - 1, times |p_t|^3 / mu above and below.
    const double normal_slope = coupling_[0] * trial.solved[0] + coupling_[1] * trial.solved[1];
    const double size_slope_size = -(trial.tangential[0] * trial.solved[0] + trial.tangential[1] * trial.solved[1]);
    const double square = trial.size * trial.size;
    const double slope = normal_slope * square - trial.normal * size_slope_size;
    return square * trial.excess(friction_) / (friction_ * slope);
}

ContactVector CoulombContact::solve(const ContactVector &b, double &multiplier) const
{
    const double normal_alone = -b[0] * inverse_normal_; // what stops b without friction
    if (!(normal_alone > 0) || friction_ <= 0) {
        multiplier = 0;
        return {std::max(normal_alone, 0.0), 0, 0};
    }
    const std::array<double, 2> c = {b[1] - coupling_[0] * b[0], b[2] - coupling_[1] * b[0]};
    const double enough = tolerance * normal_alone;
    // The excess falls with the multiplier: for a large one the tangential impulse vanishes and the normal one stays.
    // So either the excess at 0 is not positive and the contact sticks, or there is one root.
    double low = -1, high = std::numeric_limits<double>::infinity(); // low < 0: not even 0 is known to be too small
    Trial trial = try_multiplier(multiplier, normal_alone, c);
    for (int i = 0; i < most_steps; i++) {
        const double excess = trial.excess(friction_);
        if (std::abs(excess) <= enough || (excess < 0 && multiplier == 0)) break;
        (excess > 0 ? low : high) = multiplier;
        double next = multiplier + newton_step(trial);
        if (!(next > std::max(low, 0.0) && next < high)) next = between(low, high, schur_[0] + schur_[2]);
        if (next == multiplier) break; // no number lies between
        multiplier = next;
        trial = try_multiplier(multiplier, normal_alone, c);
    }
    return {std::max(trial.normal, 0.0), trial.tangential[0], trial.tangential[1]};
}

} // namespace twiddle::sim
