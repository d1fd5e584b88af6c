// table_text.hpp: what the tables of a sweep share: their cells as text, in CSV and Markdown.
#pragma once

#include "sweep_results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace twiddle::experiment
{

using Texts = std::vector<std::string>;

// A number in full precision for CSV; empty for none.
std::string full(const std::optional<double> &value);

// "true" or "false".
std::string truth(bool value);

// A number with `digits` digits after the point.
std::string fixed(double value, int digits);

// "CPG-H", "CPG-H without centre".
std::string model_text(const std::string &model, bool centre);

// What a run of `sweep` counts with.
std::string rotation_text(const Sweep &sweep);

// Where the numbers come from: the sweep, and the program that made the runs and the one that summarizes them.
std::string origin_text(const Sweep &sweep);

// A CSV file: each of `comments` as a line "# ...", the columns' names, the rows.
std::string csv_text(const Texts &comments, const Texts &columns, const std::vector<Texts> &rows);

// A Markdown table; a sentence where it has no rows.
std::string markdown_table(const Texts &columns, const std::vector<Texts> &rows);

} // namespace twiddle::experiment
