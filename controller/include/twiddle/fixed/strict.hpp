// fixed/strict.hpp: the formats of the fixed build as classes, so that a compiler finds every product of raw words and
// every mixture of two formats. For checks only: compiled as C++20 with TWD_STRICT_TYPES.
#ifndef TWIDDLE_FIXED_STRICT_HPP
#define TWIDDLE_FIXED_STRICT_HPP

#ifndef __cplusplus
#error "TWD_STRICT_TYPES is for a C++ compiler"
#endif

namespace twd_strict
{

// A word with `bits` bits behind the point. There are no `*`, no `/` and no other conversions.
template <int bits> class Number
{
  public:
    Number() = default;
    constexpr explicit Number(int32_t word) : word_(word)
    {
    }
    constexpr explicit operator int32_t() const
    {
        return word_;
    }

    friend constexpr Number operator+(Number a, Number b)
    {
        return Number(a.word_ + b.word_);
    }
    friend constexpr Number operator-(Number a, Number b)
    {
        return Number(a.word_ - b.word_);
    }
    friend constexpr Number operator-(Number a)
    {
        return Number(-a.word_);
    }
    constexpr Number &operator+=(Number other)
    {
        return *this = *this + other;
    }
    constexpr Number &operator-=(Number other)
    {
        return *this = *this - other;
    }
    friend constexpr bool operator==(Number a, Number b)
    {
        return a.word_ == b.word_;
    }
    friend constexpr bool operator!=(Number a, Number b)
    {
        return a.word_ != b.word_;
    }
    friend constexpr bool operator<(Number a, Number b)
    {
        return a.word_ < b.word_;
    }
    friend constexpr bool operator<=(Number a, Number b)
    {
        return a.word_ <= b.word_;
    }
    friend constexpr bool operator>(Number a, Number b)
    {
        return a.word_ > b.word_;
    }
    friend constexpr bool operator>=(Number a, Number b)
    {
        return a.word_ >= b.word_;
    }

  private:
    int32_t word_;
};

// Called, and so refused by the compiler, in a constant whose word is not its value.
inline void the_word_of_a_constant_is_not_its_value()
{
}

template <int bits> consteval Number<bits> checked(Number<bits> value, int32_t word)
{
    if (static_cast<int32_t>(value) != word) the_word_of_a_constant_is_not_its_value();
    return value;
}

} // namespace twd_strict

using twd_num = twd_strict::Number<28>;
using twd_wide = twd_strict::Number<24>;
using twd_rate = twd_strict::Number<20>;
using twd_small = twd_strict::Number<34>;

#endif
