#include "mann_whitney.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/binomial.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace twiddle::results
{

namespace
{

double statistic(const std::vector<double> &a, const std::vector<double> &b)
{
    double u = 0;
    for (const double left : a) {
        for (const double right : b) {
            u += left > right ? 1 : left == right ? 0.5 : 0;
        }
    }
    return u;
}

// Sum of t^3 - t over the groups of t equal values; 0 if there is no tie.
double tie_sum(const std::vector<double> &a, const std::vector<double> &b)
{
    std::vector<double> all = a;
    all.insert(all.end(), b.begin(), b.end());
    std::sort(all.begin(), all.end());
    double sum = 0;
    for (auto first = all.begin(); first != all.end();) {
        const auto next = std::upper_bound(first, all.end(), *first);
        const auto equal = static_cast<double>(next - first);
        sum += equal * equal * equal - equal;
        first = next;
    }
    return sum;
}

double arrangements(std::size_t a, std::size_t b)
{
    return boost::math::binomial_coefficient<double>(static_cast<unsigned>(a + b), static_cast<unsigned>(a));
}

// How many arrangements of `a` and `b` values have U = 0, 1, ..., a b: the coefficients of the Gaussian binomial, the
// product of (1 - q^(b + i)) / (1 - q^i) over i = 1 ... a. Whole numbers far below 2^63 for groups up to
// exact_group_size.
std::vector<std::int64_t> arrangements_by_u(std::size_t a, std::size_t b)
{
    std::vector<std::int64_t> count(a * b + 1, 0);
    count[0] = 1;
    for (std::size_t i = 1; i <= a; ++i) {
        for (std::size_t u = a * b; u >= b + i; --u) {
            count[u] -= count[u - b - i];
        }
        for (std::size_t u = i; u <= a * b; ++u) {
            count[u] += count[u - i];
        }
    }
    return count;
}

double exact_p(double u, std::size_t a, std::size_t b)
{
    const double pairs = static_cast<double>(a) * static_cast<double>(b);
    const auto nearer_end = static_cast<std::size_t>(std::min(u, pairs - u)); // the distribution is symmetric
    const std::vector<std::int64_t> count = arrangements_by_u(a, b);
    double at_least_as_far = 0;
    for (std::size_t i = 0; i <= nearer_end; ++i) {
        at_least_as_far += static_cast<double>(count[i]);
    }
    return std::min(1.0, 2 * at_least_as_far / arrangements(a, b));
}

double normal_p(double u, std::size_t a, std::size_t b, double ties)
{
    const double pairs = static_cast<double>(a) * static_cast<double>(b);
    const double all = static_cast<double>(a + b);
    const double variance = pairs / 12 * (all + 1 - ties / (all * (all - 1)));
    if (variance <= 0) return 1; // all values are equal
    const double distance = std::max(0.0, std::abs(u - pairs / 2) - 0.5);
    const boost::math::normal standard;
    return 2 * boost::math::cdf(boost::math::complement(standard, distance / std::sqrt(variance)));
}

} // namespace

MannWhitney mann_whitney(const std::vector<double> &a, const std::vector<double> &b)
{
    const double u = statistic(a, b);
    const double ties = tie_sum(a, b);
    const bool exact = ties == 0 && std::max(a.size(), b.size()) <= exact_group_size;
    return {u, exact ? exact_p(u, a.size(), b.size()) : normal_p(u, a.size(), b.size(), ties), exact};
}

double smallest_mann_whitney_p(std::size_t a, std::size_t b)
{
    return std::min(1.0, 2 / arrangements(a, b));
}

} // namespace twiddle::results
