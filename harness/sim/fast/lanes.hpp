// lanes.hpp: two numbers side by side, one a finger or one a direction, and vectors of such numbers.
//
// Compilers make one instruction for both lanes of a Pair on every x86-64 and arm64. Each lane has the bits that a
// double alone would have.
#pragma once

#include <LinearMath/btVector3.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace twiddle::sim
{

using Pair = double __attribute__((vector_size(16)));
using PairBits = std::uint64_t __attribute__((vector_size(16)));

// The same constant in every lane.
template <class Number> constexpr Number in_lanes(double constant);
template <> constexpr double in_lanes<double>(double constant)
{
    return constant;
}
template <> constexpr Pair in_lanes<Pair>(double constant)
{
    return Pair{constant, constant};
}

inline double square_root(double x)
{
    return std::sqrt(x);
}

inline Pair square_root(Pair x)
{
    return Pair{std::sqrt(x[0]), std::sqrt(x[1])};
}

inline Pair swapped(Pair x)
{
    return Pair{x[1], x[0]};
}

inline double sum_of_lanes(Pair x)
{
    return x[0] + x[1];
}

// The size of each lane.
inline Pair size_of(Pair x)
{
    constexpr std::uint64_t all_but_sign = ~(std::uint64_t{1} << 63);
    const PairBits bits = reinterpret_cast<PairBits>(x) & all_but_sign;
    return reinterpret_cast<Pair>(bits);
}

// A vector of space, or a lane each of two.
template <class Number> struct VectorOf {
    Number x, y, z;

    VectorOf operator+(const VectorOf &other) const
    {
        return {x + other.x, y + other.y, z + other.z};
    }
    VectorOf operator-(const VectorOf &other) const
    {
        return {x - other.x, y - other.y, z - other.z};
    }
    VectorOf operator*(Number scale) const
    {
        return {x * scale, y * scale, z * scale};
    }
    // Along axis 0, 1 or 2.
    Number operator[](int axis) const
    {
        return axis == 0 ? x : axis == 1 ? y : z;
    }
    Number dot(const VectorOf &other) const
    {
        return x * other.x + y * other.y + z * other.z;
    }
    VectorOf cross(const VectorOf &other) const
    {
        return {y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x};
    }
    Number length2() const
    {
        return dot(*this);
    }
};

using Vector = VectorOf<double>;
using PairVector = VectorOf<Pair>;

inline Vector vector_of(const btVector3 &v)
{
    return {v.x(), v.y(), v.z()};
}

inline btVector3 bullet_vector(const Vector &v)
{
    return {v.x, v.y, v.z};
}

inline PairVector pair_of(const Vector &first, const Vector &second)
{
    return {Pair{first.x, second.x}, Pair{first.y, second.y}, Pair{first.z, second.z}};
}

inline Vector lane(const PairVector &v, int i)
{
    return {v.x[i], v.y[i], v.z[i]};
}

} // namespace twiddle::sim
