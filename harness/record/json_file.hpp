// json_file.hpp: JSON files, read with errors that name file and key, written whole or not at all.
#pragma once

#include "json.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace twiddle::record
{

// Read `path`. Throws std::runtime_error with one sentence that names the file, and the line if it is no JSON object.
Json read_json(const std::filesystem::path &path);

// Write `value`, indented, under the rules of part_file.hpp.
void write_json(const std::filesystem::path &path, const Json &value);

// Whether `value` is a Value without any conversion: get() would turn a true into a 1 and a -1 into a huge count.
template <class Value> bool json_holds(const Json &value)
{
    if constexpr (std::is_same_v<Value, bool>) {
        return value.is_boolean();
    } else if constexpr (std::is_unsigned_v<Value>) {
        return value.is_number_unsigned() && value.get<std::uint64_t>() <= std::numeric_limits<Value>::max();
    } else if constexpr (std::is_floating_point_v<Value>) {
        return value.is_number();
    } else if constexpr (std::is_same_v<Value, std::string>) {
        return value.is_string();
    } else if constexpr (std::is_same_v<Value, Json> || std::is_same_v<Value, nlohmann::json>) {
        return value.is_object();
    } else {
        return value.is_array();
    }
}

// The value of `key`, which `expected` describes, for example "a whole number". Throws std::runtime_error with one
// sentence that names `path`, the key and what was expected.
template <class Value>
Value json_value(const Json &object, const std::string &key, const std::string &expected,
                 const std::filesystem::path &path)
{
    const std::string wanted = "'" + path.string() + "': '" + key + "' must be " + expected;
    const auto found = object.find(key);
    if (found == object.end()) throw std::runtime_error(wanted + ", and it is missing");
    if (!json_holds<Value>(*found)) throw std::runtime_error(wanted);
    try {
        return found->template get<Value>();
    } catch (const nlohmann::json::exception &) {
        throw std::runtime_error(wanted); // a list of something else
    }
}

} // namespace twiddle::record
