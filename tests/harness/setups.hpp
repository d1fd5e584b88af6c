// setups.hpp: the set-ups that tests use: those of experiments/setups, and mid-a, which is a fixture beside them.
#pragma once

#include "settings/setup.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::test
{

// The fixture: the object under the middle of both fingers' reach, all settings at their defaults.
inline std::string mid_a_file()
{
    return TWIDDLE_TEST_DATA "/setups/mid-a.toml";
}

inline settings::Setup load_setup(const std::string &name, const std::vector<settings::Override> &overrides = {})
{
    return settings::load_setup(TWIDDLE_SETUPS, name == "mid-a" ? mid_a_file() : name, overrides);
}

} // namespace twiddle::test
