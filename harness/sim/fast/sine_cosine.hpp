// sine_cosine.hpp: sine and cosine of joint angles, several at a time.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace twiddle::sim
{

struct SineCosine {
    double sine = 0;
    double cosine = 1;
};

inline SineCosine sine_cosine(double angle_rad)
{
    return {std::sin(angle_rad), std::cos(angle_rad)};
}

} // namespace twiddle::sim
