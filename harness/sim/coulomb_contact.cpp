#include "coulomb_contact.hpp"

#include <algorithm>
#include <cmath>

namespace twiddle::sim
{

namespace
{

// A direction in which neither body can move has no inverse mass; this share of the largest keeps it solvable.
constexpr double least_share = 1e-9;
constexpr int most_steps = 60;
constexpr double tolerance = 1e-10;

} // namespace

CoulombContact::CoulombContact(const ContactMatrix &inverse_mass, double friction)
    : inverse_mass_(inverse_mass), friction_(friction)
{
    const ContactMatrix &w = inverse_mass_;
    const double a11 = w[1][1] - w[0][1] * w[0][1] / w[0][0];
    const double a22 = w[2][2] - w[0][2] * w[0][2] / w[0][0];
    const double a12 = w[1][2] - w[0][1] * w[0][2] / w[0][0];
    const double mean = (a11 + a22) / 2, half_difference = (a11 - a22) / 2;
    const double radius = std::sqrt(half_difference * half_difference + a12 * a12);
    const double least = least_share * std::max({w[0][0], w[1][1], w[2][2]});
    eigenvalue_ = {std::max(mean + radius, least), std::max(mean - radius, least)};
    // Half the angle of (half_difference, a12) is the first eigenvector's direction.
    const double angle_rad = radius > 0 ? std::atan2(a12, half_difference) / 2 : 0;
    eigenvector_[0] = {std::cos(angle_rad), std::sin(angle_rad)};
    eigenvector_[1] = {-eigenvector_[0][1], eigenvector_[0][0]};
    for (int i = 0; i < 2; i++)
        coupling_[i] = eigenvector_[i][0] * w[0][1] + eigenvector_[i][1] * w[0][2];
}

CoulombContact::Trial CoulombContact::try_multiplier(double lambda, double b_normal,
                                                     const std::array<double, 2> &c) const
{
    Trial trial;
    trial.tangential = {-c[0] / (eigenvalue_[0] + lambda), -c[1] / (eigenvalue_[1] + lambda)};
    trial.normal =
        -(b_normal + coupling_[0] * trial.tangential[0] + coupling_[1] * trial.tangential[1]) / inverse_mass_[0][0];
    const double size =
        std::sqrt(trial.tangential[0] * trial.tangential[0] + trial.tangential[1] * trial.tangential[1]);
    trial.excess = size - friction_ * trial.normal;
    return trial;
}

ContactVector CoulombContact::solve(const ContactVector &b) const
{
    if (b[0] >= 0) return {0, 0, 0};
    if (friction_ <= 0) return {-b[0] / inverse_mass_[0][0], 0, 0};
    std::array<double, 2> c{};
    for (int i = 0; i < 2; i++) {
        const double along = eigenvector_[i][0] * b[1] + eigenvector_[i][1] * b[2];
        c[i] = along - coupling_[i] * b[0] / inverse_mass_[0][0];
    }
    Trial trial = try_multiplier(0, b[0], c);
    if (trial.excess > 0) {
        // For a large multiplier the tangential impulse vanishes and the normal one stays: the excess is negative there.
        double low = 0, low_excess = trial.excess, high = eigenvalue_[0];
        trial = try_multiplier(high, b[0], c);
        while (trial.excess > 0) {
            low = high;
            low_excess = trial.excess;
            high *= 4;
            trial = try_multiplier(high, b[0], c);
        }
        // Regula falsi (Illinois): the retained end's excess is halved, so that both ends move.
        double high_excess = trial.excess;
        const double scale = -b[0] / inverse_mass_[0][0];
        for (int i = 0; i < most_steps && std::abs(trial.excess) > tolerance * scale; i++) {
            const double middle = (low * high_excess - high * low_excess) / (high_excess - low_excess);
            trial = try_multiplier(middle, b[0], c);
            if (trial.excess > 0) {
                low = middle;
                low_excess = trial.excess;
                high_excess /= 2;
            } else {
                high = middle;
                high_excess = trial.excess;
                low_excess /= 2;
            }
        }
    }
    const auto &p = trial.tangential;
    return {std::max(trial.normal, 0.0), eigenvector_[0][0] * p[0] + eigenvector_[1][0] * p[1],
            eigenvector_[0][1] * p[0] + eigenvector_[1][1] * p[1]};
}

} // namespace twiddle::sim
