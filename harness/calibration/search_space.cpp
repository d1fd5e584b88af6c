#include "search_space.hpp"

#include "record/number_text.hpp"
#include "settings/toml_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace twiddle::calibration
{

namespace
{

using nlohmann::json;

constexpr int digits = 3;

// To `digits` significant ones.
double rounded(double value)
{
    if (value == 0) return 0;
    const double unit = std::pow(10, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
    return std::round(value * unit) / unit;
}

json value_at(const Variable &variable, double place)
{
    if (!variable.values.empty()) {
        const auto count = static_cast<double>(variable.values.size());
        return variable.values[static_cast<std::size_t>(std::min(place * count, count - 1))];
    }
    if (variable.logarithmic) return rounded(variable.lower * std::pow(variable.upper / variable.lower, place));
    return rounded(variable.lower + (variable.upper - variable.lower) * place);
}

json scaled(json joints, double factor)
{
    for (json &value : joints) {
        value = rounded(value.get<double>() * factor);
    }
    return joints;
}

void set_gains(json &hand, double natural_frequency_rad_s)
{
    const double ratio = natural_frequency_rad_s / gains_reference_rad_s;
    hand["stiffness_nm_per_rad"] = scaled(hand["stiffness_nm_per_rad"], ratio * ratio);
    hand["damping_nms_per_rad"] = scaled(hand["damping_nms_per_rad"], ratio);
}

// A setting's value as TOML. JSON writes texts, numbers and truth values alike; a table takes other signs.
std::string toml_text(const json &value)
{
    if (value.is_number_float()) return record::number_text(value.get<double>());
    if (!value.is_object()) return value.dump();
    std::string text;
    for (const auto &[key, each] : value.items()) {
        text += (text.empty() ? "{ " : ", ") + key + " = " + toml_text(each);
    }
    return text + " }";
}

} // namespace

std::vector<json> values_at(const std::vector<Variable> &variables, const Point &point)
{
    std::vector<json> values;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        values.push_back(value_at(variables[i], point[i]));
    }
    return values;
}

std::string with_values(const std::string &base_settings, const std::vector<Variable> &variables,
                        const std::vector<json> &values)
{
    json settings = json::parse(base_settings);
    for (std::size_t i = 0; i < variables.size(); ++i) {
        const std::string &name = variables[i].setting;
        if (name == gains_variable) {
            set_gains(settings["hand"], values[i].get<double>());
            continue;
        }
        settings::put_setting(settings, name, values[i]);
    }
    return settings.dump();
}

std::string setup_text(const std::string &base_settings, const std::vector<Variable> &variables,
                       const std::vector<json> &values, const std::vector<std::string> &comments)
{
    const json settings = json::parse(with_values(base_settings, variables, values));
    std::map<std::string, std::string> sections;
    const auto add = [&](const std::string &section, const std::string &key) {
        sections[section] += key + " = " + toml_text(settings.at(section).at(key)) + "\n";
    };
    for (const Variable &variable : variables) {
        if (variable.setting == gains_variable) {
            add("hand", "stiffness_nm_per_rad");
            add("hand", "damping_nms_per_rad");
            continue;
        }
        const std::size_t dot = variable.setting.find('.');
        add(variable.setting.substr(0, dot), variable.setting.substr(dot + 1));
    }
    std::string text;
    for (const std::string &comment : comments) {
        text += "# " + comment + "\n";
    }
    for (const auto &[section, lines] : sections) {
        text += "\n[" + section + "]\n" + lines;
    }
    return text;
}

} // namespace twiddle::calibration
