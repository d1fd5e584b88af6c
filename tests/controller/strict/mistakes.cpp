// Small mistakes with the numbers, one at a time: -DMISTAKE_NAME chooses it. With MISTAKE_none there is none, and this
// compiles.
#include <twiddle/number.h>

twd_num mistake(twd_num a, twd_num b, twd_wide wide);

twd_num mistake([[maybe_unused]] twd_num a, [[maybe_unused]] twd_num b, [[maybe_unused]] twd_wide wide)
{
#if defined(MISTAKE_none)
    const twd_num constant = TWD_NUM_CONSTANT(0.1, 26843546);
    return a < b ? twd_mul(a, b) + constant : twd_num_mul_wide(a, wide) - TWD_NUM(1);
#elif defined(MISTAKE_raw_product)
    return a * b;
#elif defined(MISTAKE_raw_quotient)
    return a / b;
#elif defined(MISTAKE_product_by_integer)
    return a * 2;
#elif defined(MISTAKE_sum_of_two_formats)
    return a + wide;
#elif defined(MISTAKE_comparison_of_two_formats)
    return a < wide ? a : b;
#elif defined(MISTAKE_argument_of_another_format)
    return twd_mul(a, wide);
#elif defined(MISTAKE_number_of_an_integer)
    const twd_num one = 1;
    return one;
#elif defined(MISTAKE_integer_of_a_number)
    const int32_t word = a;
    return twd_num(word);
#elif defined(MISTAKE_word_beside_its_value)
    return TWD_NUM_CONSTANT(0.1, 26843545);
#else
#error "no mistake is chosen"
#endif
}
