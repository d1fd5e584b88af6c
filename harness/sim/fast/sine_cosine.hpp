// sine_cosine.hpp: sine and cosine of an angle together, inline and without a branch.
#pragma once

#include "lanes.hpp"

namespace twiddle::sim
{

template <class Number> struct SineCosineOf {
    Number sine = Number{};
    Number cosine = Number{} + 1;
};

using SineCosine = SineCosineOf<double>;

namespace detail
{

// Number is double with Bits std::uint64_t, or Pair with PairBits.
template <class Bits, class Number> SineCosineOf<Number> sine_cosine(Number angle_rad)
{
    const auto constant = [](double c) { return in_lanes<Number>(c); };
    // Quarter turns, rounded to whole ones: adding 1.5 2^52 leaves no bits for a fraction, and the whole number
    // in the last ones.
    constexpr Number quarters_per_rad = in_lanes<Number>(0.63661977236758134308);
    constexpr Number rounder = in_lanes<Number>(6755399441055744.0);
    const Number shifted = angle_rad * quarters_per_rad + rounder;
    Bits quarters;
    std::memcpy(&quarters, &shifted, sizeof quarters);
    const Number whole = shifted - rounder;
    // Half of pi as its first 33 bits and the rest, so that the first product is exact.
    const Number x = (angle_rad - whole * constant(1.57079632673412561417)) - whole * constant(6.0771005065061922e-11);

    // Taylor's series on an eighth of a turn to either side; what is left out is below 5e-17.
    const Number xx = x * x;
    Number sine_rest = constant(-1.0 / 1307674368000);
    Number cosine_rest = constant(1.0 / 20922789888000);
    for (const double c : {1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6})
        sine_rest = sine_rest * xx + constant(c);
    for (const double c : {-1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320, -1.0 / 720, 1.0 / 24})
        cosine_rest = cosine_rest * xx + constant(c);
    const Number sine = x + x * xx * sine_rest;
    const Number cosine = constant(1) - (xx * constant(0.5) - xx * xx * cosine_rest);

    // In odd quarters sine and cosine change places; in every other half turn each has the other sign.
    Bits sine_bits, cosine_bits;
    std::memcpy(&sine_bits, &sine, sizeof sine);
    std::memcpy(&cosine_bits, &cosine, sizeof cosine);
    const Bits changed = (sine_bits ^ cosine_bits) & -(quarters & 1U);
    sine_bits ^= changed ^ ((quarters & 2U) << 62);
    cosine_bits ^= changed ^ (((quarters + 1) & 2U) << 62);
    SineCosineOf<Number> both;
    std::memcpy(&both.sine, &sine_bits, sizeof sine);
    std::memcpy(&both.cosine, &cosine_bits, sizeof cosine);
    return both;
}

} // namespace detail

// For |angle_rad| up to 1e5. Error at most 2e-16 times 1 + |angle_rad|.
inline SineCosine sine_cosine(double angle_rad)
{
    return detail::sine_cosine<std::uint64_t>(angle_rad);
}

// Of both lanes, each with the bits of the function above.
inline SineCosineOf<Pair> sine_cosine(Pair angle_rad)
{
    return detail::sine_cosine<PairBits>(angle_rad);
}

} // namespace twiddle::sim
