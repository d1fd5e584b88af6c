// estimate.hpp: what a sweep has to say to one part of a claim: a value, its interval, and on what they rest.
#pragma once

#include "contest.hpp"
#include "contrast.hpp"
#include "run_grid.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace twiddle::claims
{

// On which side of its bound a value must lie for the claim.
enum class Side { above, below };

// One of several numbers that must all lie on the claim's side.
struct Component {
    std::string name; // "small-cube"
    double value = 0;
    std::optional<results::Interval> interval;
};

struct Estimate {
    std::optional<double> value;
    std::optional<results::Interval> interval;
    std::vector<Component> components; // where there are several
    std::size_t objects = 0;           // that the cells belong to
    std::size_t runs = 0;              // in the cells
    std::string missing;               // why there is no value or no interval; otherwise empty
};

// What every run must have measured.
struct Need {
    bool (*is_met)(const RunMeasures &run);
    const char *what; // "trajectory.csv", as it is named when it is missing
};

// The contrasts, all of which the claim says lie on `side`: the value is that of the one farthest from it, the
// interval's ends are the farthest of their intervals' ends. With a bound between, the interval thus lies wholly on the
// claim's side exactly if all contrasts' intervals do, and wholly on the other as soon as one does. Contrasts without
// cells are left out.
Estimate estimate_of_all(const RunGrid &grid, const std::vector<Contrast> &contrasts, Side side, const Need &need);

// The share of the contests that their first model wins.
Estimate estimate_of_share_won(const RunGrid &grid, const std::vector<Contest> &contests, Rank rank);

} // namespace twiddle::claims
