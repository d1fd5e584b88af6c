// search_space.hpp: the settings that a calibration searches, as a cube of side 1, and points of that cube as settings.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace twiddle::calibration
{

// One searched setting: a range of numbers, or a list of values.
struct Variable {
    std::string setting; // "section.key", or gains_variable
    double lower = 0;
    double upper = 0;
    bool logarithmic = false;           // equal factors are equal distances
    std::vector<nlohmann::json> values; // where it is a list; lower and upper then mean nothing
};

// Not a setting of its own: the natural frequency of all PD laws, rad/s. The set-up's stiffness goes with its square
// and the damping with itself, from gains_reference_rad_s on, so that the damping ratio stays.
constexpr const char *gains_variable = "hand.natural_frequency_rad_s";
constexpr double gains_reference_rad_s = 60; // of common.toml's gains

// A value in [0, 1] a variable.
using Point = std::vector<double>;

// What the variables are at `point`. Numbers are rounded to three significant digits, to be settings that can
// be written down.
std::vector<nlohmann::json> values_at(const std::vector<Variable> &variables, const Point &point);

// `base_settings` (settings::Setup::settings) with the variables' values in their places.
std::string with_values(const std::string &base_settings, const std::vector<Variable> &variables,
                        const std::vector<nlohmann::json> &values);

// `values` as a set-up file that overrides just these settings, with `comments` before them.
std::string setup_text(const std::string &base_settings, const std::vector<Variable> &variables,
                       const std::vector<nlohmann::json> &values, const std::vector<std::string> &comments);

} // namespace twiddle::calibration
