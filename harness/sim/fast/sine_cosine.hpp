// sine_cosine.hpp: sine and cosine of an angle together, inline and without a branch.
#pragma once

#include <cstdint>
#include <cstring>

namespace twiddle::sim
{

struct SineCosine {
    double sine = 0;
    double cosine = 1;
};

// For |angle_rad| up to 1e5. Error at most 2e-16 times 1 + |angle_rad|.
inline SineCosine sine_cosine(double angle_rad)
{
    // Quarter turns, rounded to whole ones: adding 1.5 2^52 leaves no bits for a fraction, and the whole number
    // in the last ones.
    constexpr double quarters_per_rad = 0.63661977236758134308;
    constexpr double rounder = 6755399441055744.0;
    const double shifted = angle_rad * quarters_per_rad + rounder;
    std::uint64_t quarters;
    std::memcpy(&quarters, &shifted, sizeof quarters);
    const double whole = shifted - rounder;
    // Half of pi as its first 33 bits and the rest, so that the first product is exact.
    const double x = (angle_rad - whole * 1.57079632673412561417) - whole * 6.0771005065061922e-11;

    // Taylor's series on an eighth of a turn to either side; what is left out is below 5e-17.
    const double xx = x * x;
    const double sine_rest =
        -1.0 / 6 +
        xx * (1.0 / 120 +
              xx * (-1.0 / 5040 + xx * (1.0 / 362880 + xx * (-1.0 / 39916800 +
                                                             xx * (1.0 / 6227020800 + xx * (-1.0 / 1307674368000))))));
    const double cosine_rest =
        1.0 / 24 +
        xx * (-1.0 / 720 +
              xx * (1.0 / 40320 + xx * (-1.0 / 3628800 + xx * (1.0 / 479001600 + xx * (-1.0 / 87178291200 +
                                                                                       xx * (1.0 / 20922789888000))))));
    const double sine = x + x * xx * sine_rest;
    const double cosine = 1 - (xx / 2 - xx * xx * cosine_rest);

    const bool odd = (quarters & 1U) != 0;
    const double turned_sine = odd ? cosine : sine, turned_cosine = odd ? sine : cosine;
    return {(quarters & 2U) != 0 ? -turned_sine : turned_sine,
            ((quarters + 1) & 2U) != 0 ? -turned_cosine : turned_cosine};
}

} // namespace twiddle::sim
