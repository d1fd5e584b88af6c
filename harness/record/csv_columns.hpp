// csv_columns.hpp: chosen columns of a table of numbers, read without keeping the rest: a sweep's logs have
// millions of rows.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace twiddle::record
{

// The names in the header row of `path`, which follows its `#` lines. Throws std::runtime_error that names the file if
// it cannot be read or has no header row.
std::vector<std::string> read_csv_header(const std::filesystem::path &path);

// The facts in the head of `path`, its lines "# name: value" before the header row; the first of a name counts. Throws
// std::runtime_error that names the file if it cannot be read.
std::map<std::string, std::string> read_csv_facts(const std::filesystem::path &path);

// The columns `names` of `path`, one vector a name in the order asked for, one value a row; empty lines and `#`
// lines are no rows. Throws std::runtime_error with one sentence that names the file and what is wrong: no such
// column, no line end after the last row, or the row (counted from 1) that has not one cell a column or no finite
// number in a chosen one.
std::vector<std::vector<double>> read_csv_columns(const std::filesystem::path &path,
                                                  const std::vector<std::string> &names);

} // namespace twiddle::record
