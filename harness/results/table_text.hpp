// table_text.hpp: tables of texts as CSV and as Markdown.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace twiddle::results
{

using Texts = std::vector<std::string>;

// One list after the other.
Texts joined(Texts first, const Texts &second);

// `comments` under `#`, a header row, one line a row. No cell may hold a comma or a line end.
std::string csv_text(const Texts &comments, const Texts &columns, const std::vector<Texts> &rows);

// Header, rule and rows. No cell may hold a bar.
std::string markdown_table(const Texts &columns, const std::vector<Texts> &rows);

// In full precision; empty if there is none.
std::string full(const std::optional<double> &value);

// "true" or "false".
std::string truth_cell(bool value);

// With `digits` after the point.
std::string fixed(double value, int digits);

} // namespace twiddle::results
