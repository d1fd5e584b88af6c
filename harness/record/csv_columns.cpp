#include "csv_columns.hpp"

#include "csv.hpp"
#include "number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace twiddle::record
{

namespace
{

constexpr std::size_t not_chosen = static_cast<std::size_t>(-1);

std::runtime_error error_of(const std::filesystem::path &path, const std::string &what)
{
    return std::runtime_error("'" + path.string() + "' " + what);
}

std::string read_text(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw std::runtime_error("cannot read '" + path.string() + "'");
    std::string text(static_cast<std::size_t>(file.tellg()), '\0');
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

bool is_row(std::string_view line)
{
    return !line.empty() && line.front() != '#';
}

// For every column of the table, its place in `names` or not_chosen.
std::vector<std::size_t> places_of(const std::vector<std::string> &names, const std::vector<std::string> &header,
                                   const std::filesystem::path &path)
{
    std::vector<std::size_t> places(header.size(), not_chosen);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = std::find(header.begin(), header.end(), names[i]);
        if (found == header.end()) throw error_of(path, "has no column '" + names[i] + "'");
        places[static_cast<std::size_t>(found - header.begin())] = i;
    }
    return places;
}

// Append a row's chosen cells to their columns; false if the row is malformed.
bool append_row(std::string_view row, const std::vector<std::size_t> &places, std::vector<std::vector<double>> &columns)
{
    if (static_cast<std::size_t>(std::count(row.begin(), row.end(), ',')) + 1 != places.size()) return false;
    for (const std::size_t place : places) {
        const std::string_view cell = take_until(',', row);
        if (place == not_chosen) continue;
        const std::optional<double> value = parse_number(cell);
        if (!value || !std::isfinite(*value)) return false;
        columns[place].push_back(*value);
    }
    return true;
}

} // namespace

std::vector<std::string> read_csv_header(const std::filesystem::path &path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read '" + path.string() + "'");
    for (std::string line; std::getline(file, line);) {
        if (is_row(line)) return split_csv(line);
    }
    throw error_of(path, "has no header row");
}

std::map<std::string, std::string> read_csv_facts(const std::filesystem::path &path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read '" + path.string() + "'");
    std::map<std::string, std::string> facts;
    for (std::string line; std::getline(file, line) && !is_row(line);) {
        const std::size_t colon = line.find(": ");
        if (line.rfind("# ", 0) == 0 && colon != std::string::npos)
            facts.emplace(line.substr(2, colon - 2), line.substr(colon + 2));
    }
    return facts;
}

std::vector<std::vector<double>> read_csv_columns(const std::filesystem::path &path,
                                                  const std::vector<std::string> &names)
{
    const std::vector<std::size_t> places = places_of(names, read_csv_header(path), path);
    const std::string text = read_text(path);
    if (text.back() != '\n') throw error_of(path, "does not end with a whole line");
    std::vector<std::vector<double>> columns(names.size());
    std::size_t lines = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view line = take_until('\n', rest);
        if (!is_row(line)) continue;
        if (lines > 0 && !append_row(line, places, columns))
            throw error_of(path, "has no valid row " + std::to_string(lines));
        ++lines;
    }
    return columns;
}

} // namespace twiddle::record
