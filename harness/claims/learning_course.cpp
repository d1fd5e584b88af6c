#include "learning_course.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace twiddle::claims
{

namespace
{

double mean_of(const std::vector<double> &values, std::size_t from, std::size_t count)
{
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(from);
    return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(count), 0.0) / static_cast<double>(count);
}

} // namespace

std::size_t smoothing_trials(std::size_t trials)
{
    return std::clamp<std::size_t>(trials / 50, 1, 100);
}

std::size_t trials_to_reach(const std::vector<double> &rotation_rad, double target_rad)
{
    const std::size_t window = smoothing_trials(rotation_rad.size());
    double sum = 0;
    for (std::size_t i = 0; i < rotation_rad.size(); ++i) {
        sum += rotation_rad[i];
        if (i + 1 > window) sum -= rotation_rad[i - window];
        if (i + 1 >= window && sum >= target_rad * static_cast<double>(window)) return i + 1;
    }
    return rotation_rad.size();
}

double mixture_distance(const Mixture &a, const Mixture &b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += std::abs(a[i] - b[i]);
    }
    return sum / 2;
}

MixtureCourse mixture_course(const std::vector<double> &s_c, const std::vector<double> &s_m,
                             const std::vector<double> &s_s)
{
    const auto mixture = [&](std::size_t from, std::size_t count) {
        return Mixture{mean_of(s_c, from, count), mean_of(s_m, from, count), mean_of(s_s, from, count)};
    };
    const std::size_t trials = s_c.size();
    const std::size_t last = std::min(mixture_trials, trials);
    MixtureCourse course;
    course.last = mixture(trials - last, last);
    if (trials >= shortest_course) {
        course.first = mixture(0, mixture_trials);
        course.middle = mixture(settled_trial, mixture_trials);
    }
    return course;
}

} // namespace twiddle::claims
