#include "rotation_log.hpp"

#include "record/csv_columns.hpp"

#include <stdexcept>
#include <string>

namespace twiddle::results
{

std::vector<double> read_rotations(const std::filesystem::path &path, std::uint32_t trials)
{
    const std::vector<std::vector<double>> columns = record::read_csv_columns(path, {"trial", "rotation_rad"});
    const std::vector<double> &trial = columns[0];
    const auto fail = [&](const std::string &what) { throw std::runtime_error("'" + path.string() + "' " + what); };
    for (std::size_t row = 0; row < trial.size(); ++row) {
        if (trial[row] != static_cast<double>(row + 1)) fail("has no valid row " + std::to_string(row + 1));
    }
    if (trial.size() != trials)
        fail("has " + std::to_string(trial.size()) + " trials where the run has " + std::to_string(trials));
    return columns[1];
}

} // namespace twiddle::results
