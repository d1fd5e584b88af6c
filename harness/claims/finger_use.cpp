#include "finger_use.hpp"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace twiddle::claims
{

namespace
{

constexpr double turn_rad = boost::math::constants::two_pi<double>();

using Values = std::vector<double>;

// What is left after the mean is taken off.
Values centred(Values values)
{
    double sum = 0;
    for (const double value : values) {
        sum += value;
    }
    for (double &value : values) {
        value -= sum / static_cast<double>(values.size());
    }
    return values;
}

double product(const Values &a, const Values &b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

// The part of `values` whose time lies in the last compared_s.
Values last_part(const Values &time_s, const Values &values)
{
    const auto from = std::upper_bound(time_s.begin(), time_s.end(), time_s.back() - compared_s + 1e-9);
    return {values.begin() + (from - time_s.begin()), values.end()};
}

// phi of the fit m + A cos(2 pi f t + phi), from its normal equations; centring takes m out of them.
double phase_rad(const Values &time_s, const Values &values, double frequency_hz)
{
    Values cosine;
    Values sine;
    for (const double t : time_s) {
        cosine.push_back(std::cos(turn_rad * frequency_hz * t));
        sine.push_back(std::sin(turn_rad * frequency_hz * t));
    }
    cosine = centred(cosine);
    sine = centred(sine);
    const double cc = product(cosine, cosine);
    const double cs = product(cosine, sine);
    const double ss = product(sine, sine);
    const double cv = product(cosine, values);
    const double sv = product(sine, values);
    return std::atan2(-(cc * sv - cs * cv), ss * cv - cs * sv); // the determinant is positive and cancels
}

} // namespace

double lesser_finger_share(const std::vector<double> &object_rad, const std::vector<double> &index_contact_n,
                           const std::vector<double> &thumb_contact_n)
{
    double by_index_rad = 0;
    double by_thumb_rad = 0;
    double before_rad = 0;
    for (std::size_t i = 0; i < object_rad.size(); ++i) {
        const double forward_rad = std::max(0.0, object_rad[i] - before_rad);
        const double force_n = index_contact_n[i] + thumb_contact_n[i];
        before_rad = object_rad[i];
        if (!(force_n > 0)) continue;
        by_index_rad += forward_rad * index_contact_n[i] / force_n;
        by_thumb_rad += forward_rad * thumb_contact_n[i] / force_n;
    }
    const double both_rad = by_index_rad + by_thumb_rad;
    return both_rad > 0 ? std::min(by_index_rad, by_thumb_rad) / both_rad : 0;
}

double phase_distance_turns(const std::vector<double> &time_s, const std::vector<double> &a,
                            const std::vector<double> &b, double frequency_hz)
{
    const Values time = last_part(time_s, time_s);
    const double difference =
        phase_rad(time, last_part(time_s, a), frequency_hz) - phase_rad(time, last_part(time_s, b), frequency_hz);
    return std::abs(std::remainder(difference, turn_rad)) / turn_rad;
}

} // namespace twiddle::claims
