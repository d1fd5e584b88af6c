#include "json_file.hpp"

#include "part_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace twiddle::record
{

Json read_json(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read '" + path.string() + "'");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};

    Json value;
    try {
        value = Json::parse(text);
    } catch (const Json::parse_error &error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        const auto line = std::count(text.begin(), end, '\n') + 1;
        throw std::runtime_error("'" + path.string() + "' is not valid JSON (line " + std::to_string(line) + ")");
    }
    if (!value.is_object()) throw std::runtime_error("'" + path.string() + "' must hold one JSON object");
    return value;
}

void write_json(const std::filesystem::path &path, const Json &value)
{
    write_file(path, value.dump(2) + "\n");
}

} // namespace twiddle::record
