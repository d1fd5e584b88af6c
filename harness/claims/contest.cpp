#include "contest.hpp"

#include "quantiles.hpp"

#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace twiddle::claims
{

namespace
{

constexpr std::uint64_t bootstrap_seed = 1;
constexpr double tail = 0.025; // on each side of a 95 % interval

using Values = std::vector<double>;

// A cell as it is resampled.
struct Entrant {
    Values rotation_rad;
    double mean_rad = 0;
    double widening = 1; // of the distance of a resample's mean from the cell's
};

double widening_of(std::size_t runs)
{
    if (runs < 2) return 1; // not resampled
    const auto n = static_cast<double>(runs);
    return std::sqrt(n / (n - 1)) * student_quantile(n - 1, 1 - tail) / normal_quantile(1 - tail);
}

Entrant entrant_of(const Runs *cell)
{
    Entrant entrant;
    for (const RunMeasures &run : *cell) {
        entrant.rotation_rad.push_back(run.final_rotation_rad);
    }
    entrant.mean_rad = results::mean(entrant.rotation_rad);
    entrant.widening = widening_of(cell->size());
    return entrant;
}

std::vector<std::vector<Entrant>> entrants_of(const std::vector<Contest> &contests)
{
    std::vector<std::vector<Entrant>> all;
    for (const Contest &contest : contests) {
        all.emplace_back();
        std::transform(contest.begin(), contest.end(), std::back_inserter(all.back()), entrant_of);
    }
    return all;
}

// The share of objects whose first entrant scores at or above the others.
template <class Score> double share_by(const std::vector<std::vector<Entrant>> &contests, Score score)
{
    std::size_t won = 0;
    for (const std::vector<Entrant> &entrants : contests) {
        const double first = score(entrants.front());
        bool wins = true;
        for (std::size_t i = 1; i < entrants.size(); ++i) {
            wins =
                score(entrants[i]) <= first && wins; // every entrant is scored, so that each draw takes as many numbers
        }
        if (wins) ++won;
    }
    return static_cast<double>(won) / static_cast<double>(contests.size());
}

double rank_of(const Entrant &entrant, Rank rank)
{
    if (rank == Rank::mean) return entrant.mean_rad;
    return *std::max_element(entrant.rotation_rad.begin(), entrant.rotation_rad.end());
}

double drawn_rank(const Entrant &entrant, Rank rank, std::mt19937_64 &generator)
{
    // Boost's distribution, since the standard's differs from library to library.
    boost::random::uniform_int_distribution<std::size_t> place(0, entrant.rotation_rad.size() - 1);
    double sum = 0;
    double best = entrant.rotation_rad[place(generator)];
    sum += best;
    for (std::size_t i = 1; i < entrant.rotation_rad.size(); ++i) {
        const double value = entrant.rotation_rad[place(generator)];
        sum += value;
        best = std::max(best, value);
    }
    if (rank == Rank::best) return best;
    const double mean_rad = sum / static_cast<double>(entrant.rotation_rad.size());
    return entrant.mean_rad + entrant.widening * (mean_rad - entrant.mean_rad);
}

} // namespace

double share_won(const std::vector<Contest> &contests, Rank rank)
{
    return share_by(entrants_of(contests), [&](const Entrant &entrant) { return rank_of(entrant, rank); });
}

std::optional<results::Interval> interval_of_share_won(const std::vector<Contest> &contests, Rank rank)
{
    for (const Contest &contest : contests) {
        if (std::any_of(contest.begin(), contest.end(), [](const Runs *cell) { return cell->size() < 2; }))
            return std::nullopt;
    }
    const std::vector<std::vector<Entrant>> entrants = entrants_of(contests);
    std::mt19937_64 generator(bootstrap_seed);
    Values shares(results::bootstrap_resamples);
    std::generate(shares.begin(), shares.end(), [&] {
        return share_by(entrants, [&](const Entrant &entrant) { return drawn_rank(entrant, rank, generator); });
    });
    std::sort(shares.begin(), shares.end());
    return results::Interval{results::quantile_of_sorted(shares, tail), results::quantile_of_sorted(shares, 1 - tail)};
}

} // namespace twiddle::claims
