// toml_file.hpp: TOML read as JSON, the form in which settings travel.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace twiddle::settings
{

// The file `path`. Throws std::runtime_error with one sentence that names the file and, if it is malformed, the line.
nlohmann::json read_toml(const std::filesystem::path &path);

// A file's values, and where each of them stands.
struct TomlFile {
    nlohmann::json values;
    std::map<std::string, int> line; // from 1, by JSON pointer, e.g. "/runs/0/seeds"
};

// As read_toml().
TomlFile read_toml_with_lines(const std::filesystem::path &path);

// One value as written after `key =` in a file; a bare word counts as a string. Throws std::runtime_error if it is
// neither.
nlohmann::json toml_value(const std::string &text);

// Put `value` among merged settings, where `name`, "section.key", stands.
void put_setting(nlohmann::json &settings, const std::string &name, const nlohmann::json &value);

} // namespace twiddle::settings
