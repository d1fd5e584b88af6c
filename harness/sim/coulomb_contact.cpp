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
constexpr int quick_steps = 6;
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

CoulombContact::CoulombContact(const InverseMass &w, double friction)
    : friction_(friction), inverse_normal_(1 / w.normal)
{
    const Pair coupling = w.coupled * inverse_normal_;
    const double least = least_share * std::max(w.normal, std::max(w.tangential[0], w.tangential[1]));
    const Pair a = w.tangential - w.coupled * coupling + least;
    const double across = w.across - w.coupled[0] * coupling[1];

    // Of the angle t of A's first axis: cos 2t = lean / radius, sin 2t = across / radius. The half angle's larger part
    // comes first.
    const double middle = 0.5 * (a[0] + a[1]), lean = 0.5 * (a[0] - a[1]);
    const double radius = std::sqrt(lean * lean + across * across);
    if (radius > 0) {
        const double larger_part = std::sqrt(0.5 * (1 + std::abs(lean) / radius));
        const double other_part = 0.5 * across / (radius * larger_part);
        cosine_ = lean < 0 ? other_part : larger_part;
        sine_ = lean < 0 ? larger_part : other_part;
    }
    schur_ = Pair{middle + radius, std::max(middle - radius, least)};
    coupling_ = to_axes(coupling);
}

CoulombContact::CoulombContact(const ContactMatrix &w, double friction)
    : CoulombContact(InverseMass{w[0][0], Pair{w[0][1], w[0][2]}, Pair{w[1][1], w[2][2]}, w[1][2]}, friction)
{
}

inline CoulombContact::Trial CoulombContact::try_multiplier(double lambda, double normal_alone, Pair c) const
{
    Trial trial;
    trial.inverse = in_lanes<Pair>(1) / (schur_ + lambda);
    trial.tangential = -c * trial.inverse;
    trial.normal = normal_alone - sum_of_lanes(coupling_ * trial.tangential);
    trial.size = std::sqrt(sum_of_lanes(trial.tangential * trial.tangential));
    return trial;
}

inline double CoulombContact::newton_step(const Trial &trial) const
{
    // Minus the slope of p_t.
    const Pair falling = trial.tangential * trial.inverse;
    // Of f = mu p_n / |p_t| - 1, times |p_t|^3 / mu above and below.
    const double normal_slope = sum_of_lanes(coupling_ * falling);
    const double size_slope_size = -sum_of_lanes(trial.tangential * falling);
    const double square = trial.size * trial.size;
    const double slope = normal_slope * square - trial.normal * size_slope_size;
    return square * trial.excess(friction_) / (friction_ * slope);
}

ContactPair CoulombContact::solve_along_axes(const ContactPair &velocity, const ContactPair &present,
                                             double &multiplier) const
{
    // What stops the contact without friction, and the slip that this leaves.
    const double normal_alone =
        present.normal - velocity.normal * inverse_normal_ + sum_of_lanes(coupling_ * present.tangential);
    if (!(normal_alone > 0) || friction_ <= 0) {
        multiplier = 0;
        return {std::max(normal_alone, 0.0), Pair{}};
    }
    const Pair c = velocity.tangential - coupling_ * velocity.normal - schur_ * present.tangential;
    const double enough = tolerance * normal_alone;
    // Newton's steps from a good guess end after one or two.
    Trial trial = try_multiplier(multiplier, normal_alone, c);
    for (int i = 0;; i++) {
        const double excess = trial.excess(friction_);
        if (std::abs(excess) <= enough || (excess < 0 && multiplier == 0)) break;
        if (i == quick_steps) {
            trial = search(normal_alone, c, multiplier);
            break;
        }
        multiplier = std::max(multiplier + newton_step(trial), 0.0);
        trial = try_multiplier(multiplier, normal_alone, c);
    }
    return {std::max(trial.normal, 0.0), trial.tangential};
}

CoulombContact::Trial CoulombContact::search(double normal_alone, Pair c, double &multiplier) const
{
    const double enough = tolerance * normal_alone;
    if (!(multiplier < std::numeric_limits<double>::infinity())) multiplier = 0;
    // The excess falls with the multiplier: for a large one the tangential impulse vanishes and the normal one stays.
    // So either the excess at 0 is not positive and the contact sticks, or there is one root.
    double low = -1, high = std::numeric_limits<double>::infinity(); // low < 0: not even 0 is known to be too small
    Trial trial = try_multiplier(multiplier, normal_alone, c);
    for (int i = 0; i < most_steps; i++) {
        const double excess = trial.excess(friction_);
        if (std::abs(excess) <= enough || (excess < 0 && multiplier == 0)) break;
        (excess > 0 ? low : high) = multiplier;
        double next = multiplier + newton_step(trial);
        if (!(next > std::max(low, 0.0) && next < high)) next = between(low, high, sum_of_lanes(schur_));
        if (next == multiplier) break; // no number lies between
        multiplier = next;
        trial = try_multiplier(multiplier, normal_alone, c);
    }
    return trial;
}

ContactVector CoulombContact::solve(const ContactVector &b, double &multiplier) const
{
    const ContactPair along_axes = {b[0], to_axes(Pair{b[1], b[2]})};
    const ContactPair p = solve_along_axes(along_axes, {}, multiplier);
    const Pair tangential = from_axes(p.tangential);
    return {p.normal, tangential[0], tangential[1]};
}

} // namespace twiddle::sim
