/* The fixed build's words: every operation of two of them, and how cores with and without a long multiplication make
 * the products, for all edges and a million random pairs (fixed_words.h). */
#include "fixed_words.h"

/* The operations on two words. */
typedef int32_t word_operation(int32_t a, int32_t b);

/* Products: what they divide by, as a power of two, is that of their factors' units by the result's. */
static const struct {
    const char *name;
    word_operation *operation;
    int bits;
} products[] = {
    {"twd_mul_saturated", twd_mul_saturated, 28 + 28 - 28},
    {"twd_wide_mul", twd_wide_mul, 28 + 24 - 24},
    {"twd_num_mul_wide", twd_num_mul_wide, 28 + 24 - 28},
    {"twd_num_mul_rate", twd_num_mul_rate, 28 + 20 - 28},
    {"twd_num_mul_small", twd_num_mul_small, 28 + 34 - 28},
    {"twd_num_mul_rate_small", twd_num_mul_rate_small, 20 + 34 - 28},
    {"twd_small_mul", twd_small_mul, 28 + 34 - 34},
};

/* Products are rounded to nearest, a half upwards, and stay at the ends of the range. */
static void check_products(int32_t a, int32_t b)
{
    for (size_t i = 0; i < sizeof products / sizeof products[0]; i++) {
        const int64_t unit = (int64_t)1 << products[i].bits;
        const int64_t expected = limited(floor_quotient((int64_t)a * b + unit / 2, unit));
        assert_word(products[i].name, a, b, products[i].operation(a, b), expected);
    }
}

static void products_are_rounded_and_saturated(void **state)
{
    (void)state;
    for_all_pairs(check_products);
}

/* The products that do not saturate are exact too where the result is inside the range: twd_mul rounds to nearest,
 * twd_mul_short down to a multiple of 16 words, twd_wide_product down to a word of the wider format, for all
 * factors. */
static void check_quick_products(int32_t a, int32_t b)
{
    const int64_t product = (int64_t)a * b;
    const int64_t rounded = floor_quotient(product + (INT32_C(1) << 27), INT32_C(1) << 28);
    if (rounded == limited(rounded)) {
        assert_word("twd_mul", a, b, twd_mul(a, b), rounded);
        assert_word("twd_mul_short", a, b, twd_mul_short(a, b), floor_quotient(product, (int64_t)1 << 32) * 16);
    }
    assert_word("twd_wide_product", a, b, twd_wide_product(a, b), floor_quotient(product, (int64_t)1 << 32));
}

static void quick_products_are_exact_inside_the_range(void **state)
{
    (void)state;
    for_all_pairs(check_quick_products);
}

static int64_t magnitude(int64_t value)
{
    return value < 0 ? -value : value;
}

/* Quotients, with what the numerator is multiplied by. */
static const struct {
    const char *name;
    word_operation *operation;
    int bits;
} quotients[] = {
    {"twd_div", twd_div, 28},
    {"twd_ratio", twd_ratio, 28},
    {"twd_wide_div", twd_wide_div, 24},
    {"twd_num_div_wide", twd_num_div_wide, 24},
    {"twd_wide_div_small", twd_wide_div_small, 24},
};

/* Quotients are rounded to nearest, a half away from 0, and stay at the ends of the range; a divisor of 0 counts as the
 * smallest number, one word. */
static void check_quotients(int32_t a, int32_t b)
{
    for (size_t i = 0; i < sizeof quotients / sizeof quotients[0]; i++) {
        const int64_t numerator = (int64_t)a * ((int64_t)1 << quotients[i].bits);
        const int64_t divisor = b == 0 ? 1 : b;
        const int64_t truncated = numerator / divisor;
        const bool away = 2 * magnitude(numerator % divisor) >= magnitude(divisor);
        const int64_t step = (numerator < 0) == (divisor < 0) ? 1 : -1;
        const int64_t expected = limited(away ? truncated + step : truncated);
        assert_word(quotients[i].name, a, b, quotients[i].operation(a, b), expected);
    }
}

static void quotients_are_rounded_and_saturated(void **state)
{
    (void)state;
    for_all_pairs(check_quotients);
    assert_int_equal(twd_div(1, 0), TWD_NUM(1));
    assert_int_equal(twd_div(TWD_NUM(-1), 0), -INT32_MAX);
    assert_int_equal(twd_div(0, 0), 0);
}

static void check_sums(int32_t a, int32_t b)
{
    const int64_t sum = (int64_t)a + b;
    const int64_t difference = (int64_t)a - b;
    assert_word("twd_add_saturated", a, b, twd_add_saturated(a, b), limited(sum));
    assert_word("twd_wide_add", a, b, twd_wide_add(a, b), limited(sum));
    assert_word("twd_subtract_saturated", a, b, twd_subtract_saturated(a, b), limited(difference));
    assert_word("twd_wide_subtract", a, b, twd_wide_subtract(a, b), limited(difference));
}

static void sums_are_saturated(void **state)
{
    (void)state;
    for_all_pairs(check_sums);
}

/* From one format to another, and halves: more bits saturate, fewer bits round down. */
static void check_one_word(int32_t a, int32_t unused)
{
    (void)unused;
    assert_word("twd_num_of_wide", a, 0, twd_num_of_wide(a), limited((int64_t)a * 16));
    assert_word("twd_wide_of_num", a, 0, twd_wide_of_num(a), floor_quotient(a, 16));
    assert_word("twd_wide_half", a, 0, twd_wide_half(a), floor_quotient(a, 2));
    assert_word("twd_small_half", a, 0, twd_small_half(a), floor_quotient(a, 2));
}

/* Only what is strictly inside the range is used. */
static void check_usable(int32_t a, int32_t unused)
{
    const bool inside = a != INT32_MIN && a != -INT32_MAX && a != INT32_MAX;
    (void)unused;
    assert_true(twd_is_usable(a) == inside && twd_wide_is_usable(a) == inside);
    assert_true(twd_rate_is_usable(a) == inside && twd_small_is_usable(a) == inside);
    assert_true(twd_wide_is_finite(a) == (a != INT32_MIN));
}

static void formats_are_converted(void **state)
{
    (void)state;
    for_all_pairs(check_one_word);
    for_all_pairs(check_usable);
}

/* The forms for cores that multiply 16 bits at a time, and the ones of this core, are the exact products and their
 * upper halves. */
static void check_pieces(int32_t a, int32_t b)
{
    const int64_t product = (int64_t)a * b;
    const int64_t high = floor_quotient(product, (int64_t)1 << 32);
    assert_word("twd_high_word", a, b, twd_high_word(a, b), high);
    assert_word("twd_high_word_of_pieces", a, b, twd_high_word_of_pieces(a, b), high);
    assert_word("twd_add_high_word", a, b, twd_add_high_word(-7, a, b), high - 7);
    assert_word("twd_product", a, b, twd_product(a, b), product);
    assert_word("twd_product_of_pieces", a, b, twd_product_of_pieces(a, b), product);

    const int64_t square = floor_quotient((int64_t)a * a, (int64_t)1 << 32);
    assert_word("twd_high_word_of_square", a, a, twd_high_word_of_square(a), square);
    assert_word("twd_high_word_of_square_of_pieces", a, a, twd_high_word_of_square_of_pieces(a), square);

    const uint32_t factor = (uint32_t)b % UINT32_C(0x10001);
    for (unsigned shift = 0; shift <= 16; shift++) {
        const int64_t scaled = floor_quotient((int64_t)a * (int64_t)factor, (int64_t)1 << (16 + shift));
        assert_word("twd_scaled_by_pieces", a, (int32_t)factor, twd_scaled_by_pieces(a, factor, shift), scaled);
    }
    const uint32_t short_word = factor << 14;
    const int64_t added = floor_quotient((int64_t)a * (int64_t)short_word, (int64_t)1 << 32) - 7;
    assert_word("twd_add_mul_short", a, (int32_t)short_word, twd_add_mul_short(-7, a, short_word), added);
}

static void products_of_pieces_are_exact(void **state)
{
    (void)state;
    for_all_pairs(check_pieces);
}

/* A factor from [0, 1/2) keeps 16 bits behind its leading zeros, or all down to 2^-32, rounded to nearest; where that
 * would carry into a 17th bit, all are ones. */
static void check_factor(int32_t word, int32_t unused)
{
    (void)unused;
    if (word < 0 || word >= TWD_NUM(0.5)) return;
    const int64_t exact = (int64_t)word * 16; /* in units of 2^-32, as the factor's word */
    int64_t unit = (int64_t)1 << 15;
    while (unit > 1 && exact < unit << 15)
        unit /= 2;
    const int64_t nearest = floor_quotient(exact + unit / 2, unit) * unit;
    const int64_t largest = INT64_C(0xFFFF) * unit;
    const int64_t expected = nearest > largest ? largest : nearest;
    assert_word("twd_factor_of_num", word, 0, twd_factor_word(twd_factor_of_num(word)), expected);
    assert_word("twd_factor_to_subtract", word, 0, magnitude(twd_factor_word(twd_factor_to_subtract(word))), expected);
}

/* Products with a factor are exact, and rounded down. INT32_MIN is never multiplied by one. */
static void check_products_with_factors(int32_t a, int32_t b)
{
    const int32_t value = b & (TWD_NUM(0.5) - 1);
    if (a == INT32_MIN) return;
    const int64_t product = (int64_t)a * twd_factor_word(twd_factor_of_num(value));
    const int64_t added = floor_quotient(product, (int64_t)1 << 32) - 7;
    const int64_t subtracted = floor_quotient(-product, (int64_t)1 << 32) - 7;
    assert_word("twd_add_mul_factor", a, value, twd_add_mul_factor(-7, a, twd_factor_of_num(value)), added);
    assert_word("twd_subtract_mul_factor", a, value, twd_subtract_mul_factor(-7, a, twd_factor_to_subtract(value)),
                subtracted);
}

static void factors_keep_16_bits(void **state)
{
    (void)state;
    for_all_pairs(check_factor);
    for_all_pairs(check_products_with_factors);
}

/* The operations shift negative words to the right and convert words beyond INT32_MAX to int32_t; C leaves both to the
 * compiler, and this is what they rely on. */
static void the_compiler_keeps_the_sign(void **state)
{
    volatile int32_t negative = -5;
    volatile int64_t long_negative = -5;
    volatile uint32_t large = UINT32_C(0xFFFFFFFB);
    (void)state;
    assert_int_equal(negative >> 1, -3);
    assert_true(long_negative >> 1 == -3);
    assert_int_equal((int32_t)large, -5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_are_rounded_and_saturated),
        cmocka_unit_test(quick_products_are_exact_inside_the_range),
        cmocka_unit_test(quotients_are_rounded_and_saturated),
        cmocka_unit_test(sums_are_saturated),
        cmocka_unit_test(formats_are_converted),
        cmocka_unit_test(products_of_pieces_are_exact),
        cmocka_unit_test(factors_keep_16_bits),
        cmocka_unit_test(the_compiler_keeps_the_sign),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
