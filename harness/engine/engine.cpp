#include "engine.hpp"

#include "number_engines.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace twiddle::engine
{

const std::vector<std::string> &number_names()
{
    static const std::vector<std::string> names = {"float", "double", "fixed"};
    return names;
}

const Engine &engine_of_number(const std::string &number)
{
    static const std::array<const Engine *, 3> engines = {&twd_float::engine, &twd_double::engine, &twd_fixed::engine};
    const auto &names = number_names();
    const auto found = std::find(names.begin(), names.end(), number);
    if (found == names.end()) throw std::out_of_range("there is no number type '" + number + "'");
    return *engines.at(static_cast<std::size_t>(found - names.begin()));
}

} // namespace twiddle::engine
