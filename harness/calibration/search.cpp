#include "search.hpp"

// Boost's distributions, since the standard's differ from library to library.
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace twiddle::calibration
{

Search::Search(SearchPlan plan, std::vector<Variable> variables, std::function<bool(const Point &point)> fits)
    : plan_(plan), variables_(std::move(variables)), fits_(std::move(fits)), generator_(plan.seed)
{
}

bool Search::is_done() const
{
    return errors_.size() == plan_.random + plan_.refined;
}

Point Search::next()
{
    for (std::size_t i = 0; i < most_tries; ++i) {
        Point point = points_.size() < plan_.random ? random_point() : refined_point();
        if (!fits_(point)) continue;
        points_.push_back(point);
        return point;
    }
    throw std::runtime_error("no set-up of the calibration's ranges meets its conditions of reach (" +
                             std::to_string(most_tries) + " tried); widen the ranges or the windows");
}

void Search::tell(double error)
{
    errors_.push_back(error);
}

std::vector<std::size_t> Search::ranking() const
{
    std::vector<std::size_t> places(errors_.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return errors_[a] < errors_[b]; });
    return places;
}

const Point &Search::point(std::size_t place) const
{
    return points_.at(place);
}

Point Search::random_point()
{
    boost::random::uniform_01<double> uniform;
    Point point(variables_.size());
    std::generate(point.begin(), point.end(), [&] { return uniform(generator_); });
    return point;
}

Point Search::refined_point()
{
    const std::size_t parents = std::min(plan_.parents, errors_.size());
    boost::random::uniform_int_distribution<std::size_t> any(0, parents - 1);
    Point point = points_[ranking()[any(generator_)]];
    const double share = static_cast<double>(points_.size() - plan_.random) /
                         static_cast<double>(std::max<std::size_t>(1, plan_.refined));
    boost::random::normal_distribution<double> step(0, first_spread + share * (last_spread - first_spread));
    boost::random::uniform_01<double> uniform;
    for (std::size_t i = 0; i < point.size(); ++i) {
        if (variables_[i].values.empty()) {
            point[i] = std::clamp(point[i] + step(generator_), 0.0, 1.0);
        } else if (uniform(generator_) < chance_of_other_value) {
            point[i] = uniform(generator_);
        }
    }
    return point;
}

} // namespace twiddle::calibration
