// rotation_log.hpp: the rotations of a complete trials.csv, read without the other columns: a sweep has
// millions of rows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace twiddle::results
{

// The column rotation_rad, in rad, of all `trials` trials in `path`. The whole file is checked: columns `trial` and
// `rotation_rad`, one cell a column in every row, trials from 1 to `trials` in order, finite rotations, a line end
// after the last. Throws std::runtime_error with one sentence that names the file, and the row where there is one.
std::vector<double> read_rotations(const std::filesystem::path &path, std::uint32_t trials);

} // namespace twiddle::results
