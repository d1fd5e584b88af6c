// contrast.hpp: a number that compares cells of a sweep, and how sure it is.
//
// Objects and models are fixed; only the seed is drawn at random, so that the uncertainty is that of the runs
// within their cells.
#pragma once

#include "results/statistics.hpp"
#include "run_grid.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twiddle::claims
{

// A number of one or a few cells, for example the difference of two cells' means.
using CellMeasure = std::function<double(const std::vector<const Runs *> &)>;

// A weighted sum of one measure over groups of cells.
class Contrast
{
  public:
    // `name` says which component of a claim this is ("small-cube"). The measure needs `fewest_runs`
    // runs in every cell.
    Contrast(std::string name, CellMeasure measure, std::size_t fewest_runs);

    // Add weight times the measure of `cells`, none of them null, which must outlive the contrast.
    void add(double weight, const std::vector<const Runs *> &cells);

    const std::string &name() const
    {
        return name_;
    }
    bool empty() const
    {
        return terms_.empty();
    }

    // The cells, each once.
    const std::vector<const Runs *> &cells() const
    {
        return cells_;
    }

    // Whether every cell has `more` runs beyond the fewest that the measure needs.
    bool has_runs(std::size_t more) const;

    // The sum; asks for has_runs(0) and at least one term.
    double value() const;

    // Its 95 % interval; nothing unless has_runs(1).
    //
    // value() -+ t SE, with SE^2 = sum over cells V_c and the cells' jackknife variances V_c = (n - 1) / n sum_i
    // (E_i - mean E)^2, where E_i is the value without run i (Efron and Tibshirani 1993, ch. 11; cell by cell, since
    // runs are drawn cell by cell); t is Student's 97.5 % quantile with Welch and Satterthwaite's degrees of freedom
    // (sum V_c)^2 / sum (V_c^2 / (n_c - 1)). Why no percentile bootstrap: resampling four runs makes only 35 different
    // samples, their variance is too small by (n - 1) / n and normal quantiles take the place of t, so that it covers
    // the mean of four normal values in 81 of 100 samples. For a cell's mean this interval is Student's, exact for
    // normal values at any n; for a difference of two means it is Welch's. For the spread of four runs it is wide: it
    // held the truth in 98 of 100 samples (test_contrast).
    std::optional<results::Interval> interval() const;

  private:
    struct Term {
        double weight;
        std::vector<std::size_t> cells; // places in cells_
    };

    std::size_t place_of(const Runs *cell);
    double value_of(const std::vector<const Runs *> &cells) const;
    double jackknife_variance(std::size_t cell) const;

    std::string name_;
    CellMeasure measure_;
    std::size_t fewest_runs_;
    std::vector<const Runs *> cells_;
    std::vector<Term> terms_;
};

} // namespace twiddle::claims
