// setting_table.hpp: the one table of all settings: where each lives in a Setup and which values it takes.
#pragma once

#include "setup.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace twiddle::settings
{

// One setting: [section] key in a file.
struct Setting {
    std::string section;
    std::string key;
    std::string expected; // what its value must be, to stand after "expected", e.g. "a number from 0 to 1"
    // Put `value` into its place; false if it is not as expected.
    std::function<bool(const nlohmann::json &value, Setup &setup)> store;
};

// All settings, section by section.
const std::vector<Setting> &setting_table();

} // namespace twiddle::settings
