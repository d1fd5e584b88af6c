// paper_distance.hpp: how far a sweep's rotations are from the paper's rewards.
//
// Rewards differ by factors, not by amounts, so that the distance is between logarithms: 0.5 means a factor of
// e^0.5 = 1.65 in the root mean square. The paper does not state its unit: the distance is given with rewards read as
// rad, and with the one common factor fitted that brings ours nearest to the paper's.
#pragma once

#include "paper_values.hpp"
#include "sweep_results.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace twiddle::results
{

// A mean of ours beside the paper's.
struct PaperPair {
    double ours_rad = 0;
    double paper = 0; // its reward; above 0
};

// A rotation below this has no useful logarithm and counts as this much, rad.
constexpr double least_rotation_rad = 0.05;

struct PaperDistance {
    std::size_t pairs = 0;
    double error_rad = 0;    // root mean square of ln(ours / paper), rewards read as rad
    double scale = 1;        // the factor on ours that makes the error least
    double error_scaled = 0; // with that factor
};

// At least one pair.
PaperDistance distance_from_paper(const std::vector<PaperPair> &pairs);

// The means of the cells of `objects` that the paper has too: Table 2's models with centre, and Table 1's CPG-H
// without. Cells of a sweep's variants are left out.
std::vector<PaperPair> paper_pairs(const std::vector<Cell> &cells, const PaperValues &paper,
                                   const std::vector<std::string> &objects);

} // namespace twiddle::results
