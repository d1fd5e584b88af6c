// search.hpp: which points to try: random ones first, then ones near the best so far, a little nearer with each.
//
// A plain search, since an error that comes from learning jumps with its seed, and a derivative-free optimiser that
// trusts single values is led astray by that. It asks for one point after the other and is the same on every machine.
#pragma once

#include "search_space.hpp"

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace twiddle::calibration
{

// How the points are spread.
struct SearchPlan {
    std::uint64_t seed = 1;
    std::size_t random = 0;  // points that fill the cube evenly by chance
    std::size_t refined = 0; // points near one of the `parents` best so far
    std::size_t parents = 1;
};

// Standard deviation of the step from a parent in each direction, from the first refined point to the last, and the
// chance of another value where a variable is a list.
constexpr double first_spread = 0.15;
constexpr double last_spread = 0.04;
constexpr double chance_of_other_value = 0.1;

class Search
{
  public:
    // `fits` says whether a point is worth trying.
    Search(SearchPlan plan, std::vector<Variable> variables, std::function<bool(const Point &point)> fits);

    // Whether all points were asked for.
    bool is_done() const;

    // The next point. Throws std::runtime_error if none of `most_tries` points fits.
    Point next();

    // The error of the point that next() gave last.
    void tell(double error);

    // Points in the order of their errors, the best first: places in the order in which next() gave them.
    std::vector<std::size_t> ranking() const;

    // The point that next() gave at this place.
    const Point &point(std::size_t place) const;

    static constexpr std::size_t most_tries = 100'000;

  private:
    Point random_point();
    Point refined_point();

    SearchPlan plan_;
    std::vector<Variable> variables_;
    std::function<bool(const Point &point)> fits_;
    std::mt19937_64 generator_;
    std::vector<Point> points_;
    std::vector<double> errors_;
};

} // namespace twiddle::calibration
