#include "toml_file.hpp"

#include "text_file.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace twiddle::settings
{
namespace
{

nlohmann::json json_of(const toml::node &node)
{
    if (const auto *table = node.as_table()) {
        auto object = nlohmann::json::object();
        for (const auto &[key, value] : *table)
            object[std::string(key.str())] = json_of(value);
        return object;
    }
    if (const auto *array = node.as_array()) {
        auto list = nlohmann::json::array();
        for (const auto &value : *array)
            list.push_back(json_of(value));
        return list;
    }
    if (const auto *text = node.as_string()) return text->get();
    if (const auto *whole = node.as_integer()) return whole->get();
    if (const auto *real = node.as_floating_point()) return real->get();
    if (const auto *flag = node.as_boolean()) return flag->get();
    std::ostringstream date; // a date or a time: no setting is one, so that its text is enough for an error
    node.visit([&date](const auto &value) {
        if constexpr (toml::is_chronological<decltype(value)>) date << value.get();
    });
    return date.str();
}

// Note the lines of all that is in `node`, which stands at `place`.
void note_lines(const toml::node &node, const nlohmann::json::json_pointer &place, std::map<std::string, int> &line)
{
    line[place.to_string()] = static_cast<int>(node.source().begin.line);
    if (const auto *table = node.as_table()) {
        for (const auto &[key, value] : *table)
            note_lines(value, place / std::string(key.str()), line);
    }
    if (const auto *array = node.as_array()) {
        for (std::size_t i = 0; i < array->size(); ++i)
            note_lines((*array)[i], place / i, line);
    }
}

toml::table parse_file(const std::filesystem::path &path)
{
    const std::string text = read_text_file(path);
    try {
        return toml::parse(text);
    } catch (const toml::parse_error &error) {
        throw std::runtime_error(path.string() + ":" + std::to_string(error.source().begin.line) +
                                 ": this is no valid TOML: " + std::string(error.description()));
    }
}

// A word of letters, digits, - and _ that starts with a letter and means nothing in TOML.
bool is_bare_word(const std::string &text)
{
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto is_part = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
    if (text.empty() || !is_letter(text[0]) || !std::all_of(text.begin(), text.end(), is_part)) return false;
    return text != "true" && text != "false" && text != "inf" && text != "nan";
}

} // namespace

nlohmann::json read_toml(const std::filesystem::path &path)
{
    return json_of(parse_file(path));
}

TomlFile read_toml_with_lines(const std::filesystem::path &path)
{
    const toml::table table = parse_file(path);
    TomlFile file{json_of(table), {}};
    note_lines(table, nlohmann::json::json_pointer(), file.line);
    return file;
}

nlohmann::json toml_value(const std::string &text)
{
    if (is_bare_word(text)) return text;
    try {
        const toml::table table = toml::parse("value = " + text);
        if (table.size() == 1) return json_of(*table.get("value"));
    } catch (const toml::parse_error &) {
    }
    const auto quoted = nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    throw std::runtime_error(quoted + " is not one TOML value");
}

void put_setting(nlohmann::json &settings, const std::string &name, const nlohmann::json &value)
{
    const std::size_t dot = name.find('.');
    settings[name.substr(0, dot)][name.substr(dot + 1)] = value;
}

} // namespace twiddle::settings
