#include "rotation_log.hpp"

#include "record/csv.hpp"
#include "record/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace twiddle::experiment
{

namespace
{

std::string read_text(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::string text(file ? static_cast<std::size_t>(file.tellg()) : 0, '\0');
    file.seekg(0);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file) throw std::runtime_error("cannot read '" + path.string() + "'");
    return text;
}

// Takes the text before the next `mark` off the front of `rest`, and the mark.
std::string_view take_until(char mark, std::string_view &rest)
{
    const std::size_t end = std::min(rest.find(mark), rest.size());
    const std::string_view taken = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return taken;
}

// Where the two columns stand in a row.
struct Columns {
    std::size_t trial = 0;
    std::size_t rotation = 0;
    std::size_t count = 0;
};

Columns find_columns(std::string_view header)
{
    const std::vector<std::string> names = record::split_csv(std::string(header));
    const auto place = [&](const char *name) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) throw std::runtime_error(std::string("has no column '") + name + "'");
        return static_cast<std::size_t>(found - names.begin());
    };
    return {place("trial"), place("rotation_rad"), names.size()};
}

// The rotation in a row, which must be that of `trial`; nothing if it is not.
std::optional<double> rotation_of(std::string_view row, const Columns &columns, std::uint64_t trial)
{
    std::optional<std::uint64_t> number;
    std::optional<double> rotation_rad;
    if (static_cast<std::size_t>(std::count(row.begin(), row.end(), ',')) + 1 != columns.count) return std::nullopt;
    for (std::size_t i = 0; i <= std::max(columns.trial, columns.rotation); ++i) {
        const std::string_view cell = take_until(',', row);
        if (i == columns.trial) number = record::parse_whole_number(cell);
        if (i == columns.rotation) rotation_rad = record::parse_number(cell);
    }
    if (number != trial || !rotation_rad || !std::isfinite(*rotation_rad)) return std::nullopt;
    return rotation_rad;
}

std::vector<double> all_rotations(std::string_view text, std::uint32_t trials)
{
    if (text.empty() || text.back() != '\n') throw std::runtime_error("does not end with a whole line");
    std::optional<Columns> columns;
    std::uint64_t rows = 0;
    std::vector<double> rotation_rad;
    rotation_rad.reserve(trials);
    while (!text.empty()) {
        const std::string_view line = take_until('\n', text);
        if (line.empty() || line.front() == '#') continue;
        if (!columns) {
            columns = find_columns(line);
            continue;
        }
        ++rows;
        const std::optional<double> rotation = rotation_of(line, *columns, rows);
        if (!rotation) throw std::runtime_error("has no valid row of trial " + std::to_string(rows));
        rotation_rad.push_back(*rotation);
    }
    if (!columns) throw std::runtime_error("has no column 'trial'");
    if (rows != trials)
        throw std::runtime_error("has " + std::to_string(rows) + " trials where the run has " + std::to_string(trials));
    return rotation_rad;
}

} // namespace

std::vector<double> read_rotations(const std::filesystem::path &path, std::uint32_t trials)
{
    const std::string text = read_text(path);
    try {
        return all_rotations(text, trials);
    } catch (const std::runtime_error &error) {
        throw std::runtime_error("'" + path.string() + "' " + error.what());
    }
}

} // namespace twiddle::experiment
