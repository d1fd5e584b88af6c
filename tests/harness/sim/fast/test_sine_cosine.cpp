// Sine and cosine of an angle. Expected: the C library's in extended precision.
#include "sim/fast/sine_cosine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace twiddle::sim
{
namespace
{

static_assert(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits,
              "the expected values have to be better than the tested ones");

// The larger error, as a share of 1 + |angle|.
double error(double angle_rad)
{
    const SineCosine actual = sine_cosine(angle_rad);
    const long double extended_rad = angle_rad;
    const long double sine = std::abs(actual.sine - std::sin(extended_rad));
    const long double cosine = std::abs(actual.cosine - std::cos(extended_rad));
    return static_cast<double>(std::max(sine, cosine)) / (1 + std::abs(angle_rad));
}

// The header's promise, 2e-16 times 1 + |angle|, from joints' angles to an object's that was turned for hours.
TEST(fast_stepper_sine_cosine, are_within_the_promised_error)
{
    constexpr unsigned seed = 61;
    std::mt19937_64 random(seed);
    for (const double range_rad : {1e-9, 1.0, 4.0, 100.0, 1e5}) {
        std::uniform_real_distribution<double> uniform(-range_rad, range_rad);
        double largest = 0;
        for (int i = 0; i < 200000; i++)
            largest = std::max(largest, error(uniform(random)));
        std::printf("seed %u, up to %g rad: largest error %.1e of 1 + |angle|\n", seed, range_rad, largest);
        EXPECT_LE(largest, 2e-16) << range_rad;
    }
}

// Where one series gives way to the next, an eighth of a turn from each quarter, and at the quarters.
TEST(fast_stepper_sine_cosine, are_within_the_promised_error_around_every_eighth_of_a_turn)
{
    double largest = 0;
    for (int eighth = -1000; eighth <= 1000; eighth++) {
        double angle_rad = eighth * M_PI / 4;
        for (int i = 0; i < 8; i++)
            angle_rad = std::nextafter(angle_rad, -1e9);
        for (int i = 0; i < 16; i++) {
            largest = std::max(largest, error(angle_rad));
            angle_rad = std::nextafter(angle_rad, 1e9);
        }
    }
    std::printf("largest error %.1e of 1 + |angle|\n", largest);
    EXPECT_LE(largest, 2e-16);
}

// Two angles in lanes. Expected: the same bits as each alone.
TEST(fast_stepper_sine_cosine, of_lanes_are_those_of_each_angle_alone)
{
    constexpr unsigned seed = 62;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-10, 10);
    for (int i = 0; i < 100000; i++) {
        const std::array<double, 2> angle_rad = {uniform(random), uniform(random)};
        const SineCosineOf<Pair> both = sine_cosine(Pair{angle_rad[0], angle_rad[1]});
        for (int k = 0; k < 2; k++) {
            const SineCosine alone = sine_cosine(angle_rad[k]);
            ASSERT_EQ(both.sine[k], alone.sine) << angle_rad[k];
            ASSERT_EQ(both.cosine[k], alone.cosine) << angle_rad[k];
        }
    }
}

} // namespace
} // namespace twiddle::sim
