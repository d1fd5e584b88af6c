// results_text.hpp: what all tables of a sweep's results have in common as text.
#pragma once

#include "sweep_results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace twiddle::experiment
{

using Texts = std::vector<std::string>;

// Which trials a run's rotation is the mean of.
std::string rotation_text(const Sweep &sweep);

// Where the numbers come from: the sweep, and the programs that made and summarized it.
std::string origin_text(const Sweep &sweep);

// One list after the other.
Texts joined(Texts first, const Texts &second);

// A cell of a CSV: a number in full precision, empty where there is none; true or false.
std::string number_cell(const std::optional<double> &value);
std::string truth_cell(bool value);

// A CSV: `comments` without their `#`, the header row, rows of cells, none of which holds a comma.
std::string csv_text(const Texts &comments, const Texts &columns, const std::vector<Texts> &rows);

} // namespace twiddle::experiment
