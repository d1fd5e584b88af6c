#include "manifest_file.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace twiddle::settings
{

namespace
{

using nlohmann::json;

std::string list_of(const Names &names)
{
    std::string list;
    for (const std::string &name : names) {
        list += (list.empty() ? "" : ", ") + name;
    }
    return list;
}

// `value` as an error shows it.
std::string shown(const json &value)
{
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace

bool contains(const Names &names, const std::string &name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

ManifestFile::ManifestFile(const std::filesystem::path &path) : path_(path), file_(read_toml_with_lines(path))
{
}

void ManifestFile::fail(Pointer place, const std::string &what) const
{
    while (!place.empty() && file_.line.count(place.to_string()) == 0) {
        place.pop_back();
    }
    const int line = place.empty() ? 1 : file_.line.at(place.to_string());
    throw std::runtime_error(path_.string() + ":" + std::to_string(line) + ": " + what);
}

void ManifestFile::fail_value(const Pointer &place, const std::string &expected) const
{
    const std::string &key = place.back();
    if (!has(place)) fail(place, key + " is missing; expected " + expected);
    fail(place, key + " is " + shown(file_.values[place]) + "; expected " + expected);
}

bool ManifestFile::has(const Pointer &place) const
{
    return file_.values.contains(place);
}

const json &ManifestFile::at(const Pointer &place, const std::string &expected) const
{
    if (!has(place)) fail_value(place, expected);
    return file_.values[place];
}

void ManifestFile::require_keys(const Pointer &place, const Names &known) const
{
    for (const auto &[key, value] : file_.values[place].items()) {
        if (!contains(known, key))
            fail(place / key, "there is no key \"" + key + "\" here; expected one of " + list_of(known));
    }
}

std::int64_t ManifestFile::whole_number(const Pointer &place, std::int64_t upper) const
{
    const std::string expected = "a whole number from 1 to " + std::to_string(upper);
    const json &value = at(place, expected);
    if (!value.is_number_integer() || value < json(1) || value > json(upper)) fail_value(place, expected);
    return value.get<std::int64_t>();
}

std::pair<double, double> ManifestFile::range(const Pointer &place) const
{
    const std::string expected = "[lower, upper], two numbers in order";
    const json &value = at(place, expected);
    if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number())
        fail_value(place, expected);
    const std::pair<double, double> range(value[0].get<double>(), value[1].get<double>());
    if (!std::isfinite(range.first) || !std::isfinite(range.second) || !(range.first < range.second))
        fail_value(place, expected);
    return range;
}

std::string ManifestFile::name(const Pointer &place, const Names &known, const std::string &silent) const
{
    if (!has(place)) return silent;
    const json &value = file_.values[place];
    if (!value.is_string() || !contains(known, value.get<std::string>())) fail_value(place, "one of " + list_of(known));
    return value.get<std::string>();
}

Names ManifestFile::names(const Pointer &place, const Names &known) const
{
    const std::string expected = "\"all\", or a list of some of " + list_of(known);
    const json &value = at(place, expected);
    if (value == json("all")) return known;
    const bool is_list = value.is_array() && !value.empty();
    if (!is_list) fail_value(place, expected);
    Names found;
    for (const json &each : value) {
        if (!each.is_string() || !contains(known, each.get<std::string>()))
            fail(place, place.back() + " holds " + shown(each) + "; expected " + expected);
        found.push_back(each.get<std::string>());
    }
    return found;
}

std::vector<bool> ManifestFile::flags(const Pointer &place) const
{
    if (!has(place)) return {true};
    const json &value = file_.values[place];
    const bool fits = value.is_array() && !value.empty() &&
                      std::all_of(value.begin(), value.end(), [](const json &each) { return each.is_boolean(); });
    if (!fits) fail_value(place, "[true], [false] or [true, false]");
    return value.get<std::vector<bool>>();
}

std::size_t ManifestFile::blocks(const Pointer &place) const
{
    const std::string expected = "one block [[" + place.back() + "]] or more";
    const json &list = at(place, expected);
    if (!list.is_array() || list.empty()) fail_value(place, expected);
    for (const json &block : list) {
        if (!block.is_object()) fail_value(place, expected);
    }
    return list.size();
}

} // namespace twiddle::settings
