#include "statistics.hpp"

#include <boost/math/statistics/univariate_statistics.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace twiddle::results
{

namespace
{

constexpr std::uint64_t bootstrap_seed = 1;
constexpr double tail = 0.025; // on each side of a 95 % interval

double mean_of_resample(const std::vector<double> &values, std::mt19937_64 &generator)
{
    // Boost's distribution, since the standard's differs from library to library.
    boost::random::uniform_int_distribution<std::size_t> place(0, values.size() - 1);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += values[place(generator)];
    }
    return sum / static_cast<double>(values.size());
}

// The middle 95 % of what `draw` gives from a generator that is seeded anew for every call, so that no group
// depends on others.
template <class Draw> Interval middle_of_resamples(const Draw &draw)
{
    std::mt19937_64 generator(bootstrap_seed);
    std::vector<double> found(bootstrap_resamples);
    std::generate(found.begin(), found.end(), [&] { return draw(generator); });
    std::sort(found.begin(), found.end());
    return {quantile_of_sorted(found, tail), quantile_of_sorted(found, 1 - tail)};
}

} // namespace

double mean(const std::vector<double> &values)
{
    return boost::math::statistics::mean(values);
}

double standard_deviation(const std::vector<double> &values)
{
    return std::sqrt(boost::math::statistics::sample_variance(values));
}

double quantile_of_sorted(const std::vector<double> &sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Interval bootstrap_interval_of_mean(const std::vector<double> &values)
{
    return middle_of_resamples([&](std::mt19937_64 &generator) { return mean_of_resample(values, generator); });
}

double mean_difference(const std::vector<CellChange> &cells)
{
    double sum = 0;
    for (const CellChange &cell : cells) {
        sum += mean(cell.changed) - mean(cell.base);
    }
    return sum / static_cast<double>(cells.size());
}

Interval bootstrap_interval_of_mean_difference(const std::vector<CellChange> &cells)
{
    return middle_of_resamples([&](std::mt19937_64 &generator) {
        double sum = 0;
        for (const CellChange &cell : cells) {
            const double changed = mean_of_resample(cell.changed, generator);
            sum += changed - mean_of_resample(cell.base, generator);
        }
        return sum / static_cast<double>(cells.size());
    });
}

std::vector<double> holm_corrected(const std::vector<double> &p_values)
{
    std::vector<std::size_t> order(p_values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });

    std::vector<double> corrected(p_values.size());
    double largest = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        largest = std::max(largest, static_cast<double>(order.size() - i) * p_values[order[i]]);
        corrected[order[i]] = std::min(1.0, largest);
    }
    return corrected;
}

} // namespace twiddle::results
