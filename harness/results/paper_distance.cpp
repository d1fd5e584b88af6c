#include "paper_distance.hpp"

#include "record/number_text.hpp"
#include "statistics.hpp"

#include <algorithm>
#include <cmath>

namespace twiddle::results
{

namespace
{

// The paper's value for a cell; empty where it has none.
std::string paper_text(const Cell &cell, const PaperValues &paper)
{
    if (cell.centre) {
        const auto found = paper.with_centre.find({cell.object, cell.model});
        return found == paper.with_centre.end() ? "" : found->second.mean;
    }
    const auto found = paper.reward.find({cell.object, false});
    return cell.model != "cpg-h" || found == paper.reward.end() ? "" : found->second;
}

} // namespace

PaperDistance distance_from_paper(const std::vector<PaperPair> &pairs)
{
    const auto count = static_cast<double>(pairs.size());
    double sum = 0;
    double squares = 0;
    for (const PaperPair &pair : pairs) {
        const double error = std::log(std::max(pair.ours_rad, least_rotation_rad) / pair.paper);
        sum += error;
        squares += error * error;
    }
    const double mean = sum / count;
    return {pairs.size(), std::sqrt(squares / count), std::exp(-mean),
            std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

std::vector<PaperPair> paper_pairs(const std::vector<Cell> &cells, const PaperValues &paper,
                                   const std::vector<std::string> &objects)
{
    std::vector<PaperPair> pairs;
    for (const Cell &cell : cells) {
        const bool chosen = std::find(objects.begin(), objects.end(), cell.object) != objects.end();
        if (!chosen || !cell.variant.empty()) continue;
        const auto value = record::parse_number(paper_text(cell, paper));
        if (value) pairs.push_back({mean(cell.rotation_rad), *value});
    }
    return pairs;
}

} // namespace twiddle::results
