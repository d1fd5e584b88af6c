// The float and the fixed build do in one program what the double build does, each within what its numbers resolve.
#include "one_build.hpp"

#include <cmath>
#include <cstdio>

namespace
{

// Whether all of `values` are within `tolerance` of `expected`; says so if not.
bool close(const char *what, const std::vector<double> &values, const std::vector<double> &expected, double tolerance)
{
    double largest = values.size() == expected.size() && !values.empty() ? 0 : INFINITY;
    for (std::size_t i = 0; i < values.size() && i < expected.size(); ++i) {
        largest = std::fmax(largest, std::fabs(values[i] - expected[i]));
    }
    std::printf("%s: largest difference %.2g\n", what, largest);
    return largest <= tolerance;
}

bool close(const char *number, const Outcome &outcome, const Outcome &expected, double tolerance)
{
    std::printf("%s against double\n", number);
    const bool parameters = close("parameters", outcome.parameters, expected.parameters, tolerance);
    const bool desired = close("desired angles, rad", outcome.desired_rad, expected.desired_rad, tolerance);
    const bool torques = close("torques, N m", outcome.torques_nm, expected.torques_nm, tolerance);
    return parameters && desired && torques && close("reward", {outcome.reward}, {expected.reward}, tolerance);
}

} // namespace

int main()
{
    const Outcome of_double = run_double();
    const Outcome of_float = run_float();
    const Outcome of_fixed = run_fixed();
    const bool float_is_close = close("float", of_float, of_double, 1e-5);
    const bool fixed_is_close = close("fixed", of_fixed, of_double, 1e-4);
    // Rounding tells the builds apart.
    const bool are_three = of_float.desired_rad != of_double.desired_rad &&
                           of_fixed.desired_rad != of_double.desired_rad &&
                           of_fixed.desired_rad != of_float.desired_rad;
    return float_is_close && fixed_is_close && are_three ? 0 : 1;
}
