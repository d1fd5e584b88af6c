#include "cell_measures.hpp"

#include <cmath>

namespace twiddle::claims
{

namespace
{

std::vector<double> numbers_of(const Runs &runs, RunNumber number)
{
    std::vector<double> numbers;
    for (const RunMeasures &run : runs) {
        numbers.push_back(number(run));
    }
    return numbers;
}

double final_rotation_rad(const RunMeasures &run)
{
    return run.final_rotation_rad;
}

} // namespace

CellMeasure mean_of(RunNumber number)
{
    return [number](const std::vector<const Runs *> &cells) { return results::mean(numbers_of(*cells[0], number)); };
}

CellMeasure difference_of_means(RunNumber number)
{
    return [number](const std::vector<const Runs *> &cells) {
        return results::mean(numbers_of(*cells[0], number)) - results::mean(numbers_of(*cells[1], number));
    };
}

double relative_spread(const std::vector<const Runs *> &cells)
{
    const double a = results::standard_deviation(numbers_of(*cells[0], final_rotation_rad));
    const double b = results::standard_deviation(numbers_of(*cells[1], final_rotation_rad));
    return a + b > 0 ? (a - b) / (a + b) : 0;
}

double frequency_difference(const std::vector<const Runs *> &cells)
{
    double sum = 0;
    for (const RunMeasures &a : *cells[0]) {
        for (const RunMeasures &b : *cells[1]) {
            sum += std::abs(a.frequency->value_hz - b.frequency->value_hz) / a.frequency->range_hz;
        }
    }
    return sum / static_cast<double>(cells[0]->size() * cells[1]->size());
}

double score_difference_by_mixture(const std::vector<const Runs *> &cells)
{
    const Runs &runs = *cells[0];
    double weights = 0;
    double weighted_rad = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double distance = mixture_distance(runs[i].mixture->last, runs[j].mixture->last);
            weights += distance;
            weighted_rad += distance * std::abs(runs[i].final_rotation_rad - runs[j].final_rotation_rad);
        }
    }
    if (!(weights > 0)) return 0;
    return weighted_rad / weights / std::abs(results::mean(numbers_of(runs, final_rotation_rad)));
}

} // namespace twiddle::claims
