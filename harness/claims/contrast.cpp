#include "contrast.hpp"

#include "quantiles.hpp"

#include <algorithm>
#include <cmath>

namespace twiddle::claims
{

namespace
{

constexpr double upper_share = 0.975; // of a 95 % interval

} // namespace

Contrast::Contrast(std::string name, CellMeasure measure, std::size_t fewest_runs)
    : name_(std::move(name)), measure_(std::move(measure)), fewest_runs_(fewest_runs)
{
}

void Contrast::add(double weight, const std::vector<const Runs *> &cells)
{
    Term term{weight, {}};
    for (const Runs *cell : cells) {
        term.cells.push_back(place_of(cell));
    }
    terms_.push_back(std::move(term));
}

bool Contrast::has_runs(std::size_t more) const
{
    return std::all_of(cells_.begin(), cells_.end(),
                       [&](const Runs *cell) { return cell->size() >= fewest_runs_ + more; });
}

double Contrast::value() const
{
    return value_of(cells_);
}

std::optional<results::Interval> Contrast::interval() const
{
    if (!has_runs(1)) return std::nullopt;
    double sum = 0;
    double sum_of_squares = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const double variance = jackknife_variance(i);
        sum += variance;
        sum_of_squares += variance * variance / static_cast<double>(cells_[i]->size() - 1);
    }
    const double middle = value();
    if (!(sum_of_squares > 0)) return results::Interval{middle, middle};
    const double half = student_quantile(sum * sum / sum_of_squares, upper_share) * std::sqrt(sum);
    return results::Interval{middle - half, middle + half};
}

std::size_t Contrast::place_of(const Runs *cell)
{
    const auto found = std::find(cells_.begin(), cells_.end(), cell);
    const auto place = static_cast<std::size_t>(found - cells_.begin());
    if (found == cells_.end()) cells_.push_back(cell);
    return place;
}

double Contrast::value_of(const std::vector<const Runs *> &cells) const
{
    double sum = 0;
    for (const Term &term : terms_) {
        std::vector<const Runs *> chosen;
        for (const std::size_t place : term.cells) {
            chosen.push_back(cells[place]);
        }
        sum += term.weight * measure_(chosen);
    }
    return sum;
}

double Contrast::jackknife_variance(std::size_t cell) const
{
    const Runs &all = *cells_[cell];
    std::vector<const Runs *> cells = cells_;
    std::vector<double> values;
    for (std::size_t left_out = 0; left_out < all.size(); ++left_out) {
        Runs others = all;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
        cells[cell] = &others;
        values.push_back(value_of(cells));
    }
    const double middle = results::mean(values);
    double sum = 0;
    for (const double value : values) {
        sum += (value - middle) * (value - middle);
    }
    const auto n = static_cast<double>(all.size());
    return sum * (n - 1) / n;
}

} // namespace twiddle::claims
