/* The fixed build's words, for all edges and a million random pairs of all sizes, against 64-bit arithmetic that divides where the
 * library shifts. A product of two words is exact in 64 bits; INT32_MIN, which is no number, counts among the edges, since a
 * saturated result of it must be a number again. */
#include "controller_test.h"

#include <float.h>
#include <inttypes.h>
#include <stdlib.h>

#include <twiddle/convert.h>

enum { RANDOM_PAIRS = 1000000 };

static const int32_t sizes[] = {0,          1,          2,          3,          0x7FFF,     0x8000,     0x8001,
                                0xFFFF,     0x10000,    0x10001,    0x100000,   0xFFFFFF,   0x1000000,  0xFFFFFFF,
                                0x10000000, 0x10000001, 0x40000000, 0x5A5A5A5A, 0x7FFF0001, 0x7FFFFFFE, INT32_MAX};
enum { SIZES = sizeof sizes / sizeof sizes[0], EDGES = 2 * SIZES + 1 };

/* The edges are the sizes above with both signs, and INT32_MIN. */
static int32_t edge(size_t index)
{
    if (index == 2 * SIZES) return INT32_MIN;
    return index < SIZES ? sizes[index] : -sizes[index - SIZES];
}

/* A word of any size: 32 random bits, shifted right by 0 to 31. */
static int32_t random_word(uint64_t *random)
{
    *random = *random * 6364136223846793005U + 1442695040888963407U;
    const int64_t word = (int64_t)(*random >> 32) - ((int64_t)1 << 31);
    return (int32_t)(word / ((int64_t)1 << (*random >> 8 & 31U)));
}

/* Hand all pairs of edges, and random pairs, to `check`. */
static void for_all_pairs(void (*check)(int32_t a, int32_t b))
{
    uint64_t random = 20110824U;
    for (size_t i = 0; i < EDGES; i++)
        for (size_t k = 0; k < EDGES; k++)
            check(edge(i), edge(k));
    for (int pair = 0; pair < RANDOM_PAIRS; pair++) {
        const int32_t a = random_word(&random);
        check(a, random_word(&random));
    }
}

static void assert_word(const char *operation, int32_t a, int32_t b, int64_t actual, int64_t expected)
{
    if (actual != expected)
        fail_msg("%s of %" PRId32 " and %" PRId32 ": got %" PRId64 ", expected %" PRId64, operation, a, b, actual,
                 expected);
}

/* The largest whole number that is at most numerator / divisor; divisor > 0. */
static int64_t floor_quotient(int64_t numerator, int64_t divisor)
{
    const int64_t truncated = numerator / divisor;
    return numerator % divisor < 0 ? truncated - 1 : truncated;
}

static int64_t limited(int64_t value)
{
    if (value > INT32_MAX) return INT32_MAX;
    return value < -(int64_t)INT32_MAX ? -(int64_t)INT32_MAX : value;
}

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

/* The products that do not saturate are exact too where the result is inside the range: twd_mul rounds to nearest, twd_mul_short
 * down to a multiple of 16 words, twd_wide_product down to a word of the wider format, for all factors. */
static void check_quick_products(int32_t a, int32_t b)
{
    const int64_t product = (int64_t)a * b;
    const int64_t rounded = floor_quotient(product + (1 << 27), 1 << 28);
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

/* Quotients are rounded to nearest, a half away from 0, and stay at the ends of the range; a divisor of 0 counts as the smallest
 * number, one word. */
static void check_quotients(int32_t a, int32_t b)
{
    for (size_t i = 0; i < sizeof quotients / sizeof quotients[0]; i++) {
        const int64_t numerator = (int64_t)a * ((int64_t)1 << quotients[i].bits);
        const int64_t divisor = b == 0 ? 1 : b;
        const int64_t truncated = numerator / divisor;
        const bool away = 2 * llabs(numerator % divisor) >= llabs(divisor);
        const int64_t step = (numerator < 0) == (divisor < 0) ? 1 : -1;
        const int64_t expected = limited(away ? truncated + step : truncated);
        assert_word(quotients[i].name, a, b, quotients[i].operation(a, b), expected);
    }
}

static void quotients_are_rounded_and_saturated(void **state)
{
    (void)state;
    for_all_pairs(check_quotients);
    assert_int_equal(twd_div(1, 0), 1 << 28);
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

/* The forms for cores that multiply 16 bits at a time, and the ones of this core, are the exact products and their upper halves. */
static void check_pieces(int32_t a, int32_t b)
{
    const int64_t product = (int64_t)a * b;
    const int64_t high = floor_quotient(product, (int64_t)1 << 32);
    assert_word("twd_high_word", a, b, twd_high_word(a, b), high);
    assert_word("twd_high_word_of_pieces", a, b, twd_high_word_of_pieces(a, b), high);
    assert_word("twd_product", a, b, twd_product(a, b), product);
    assert_word("twd_product_of_pieces", a, b, twd_product_of_pieces(a, b), product);

    const int64_t square = floor_quotient((int64_t)a * a, (int64_t)1 << 32);
    assert_word("twd_high_word_of_square", a, a, twd_high_word_of_square(a), square);
    assert_word("twd_high_word_of_square_of_pieces", a, a, twd_high_word_of_square_of_pieces(a), square);

    for (unsigned shift = 0; shift <= 2; shift++) {
        const uint32_t factor = (uint32_t)b & (shift == 0 ? 0x7FFFU : 0xFFFFU);
        const int64_t scaled = floor_quotient((int64_t)a * (int64_t)factor, (int64_t)1 << (16 + shift));
        assert_word("twd_scaled", a, (int32_t)factor, twd_scaled(a, factor, shift), scaled);
        assert_word("twd_scaled_by_pieces", a, (int32_t)factor, twd_scaled_by_pieces(a, factor, shift), scaled);
    }
}

static void products_of_pieces_are_exact(void **state)
{
    (void)state;
    for_all_pairs(check_pieces);
}

/* The operations shift negative words to the right and convert words beyond INT32_MAX to int32_t; C leaves both to the compiler, and
 * this is what they rely on. */
static void the_compiler_keeps_the_sign(void **state)
{
    volatile int32_t negative = -5;
    volatile int64_t long_negative = -5;
    volatile uint32_t large = 0xFFFFFFFBU;
    (void)state;
    assert_int_equal(negative >> 1, -3);
    assert_true(long_negative >> 1 == -3);
    assert_int_equal((int32_t)large, -5);
}

/* The four formats' conversions. */
static const struct {
    int32_t (*from_double)(double value);
    double (*to_double)(int32_t word);
    double one;
} conversions[] = {
    {twd_num_from_double, twd_num_to_double, 268435456.0},
    {twd_wide_from_double, twd_wide_to_double, 16777216.0},
    {twd_rate_from_double, twd_rate_to_double, 1048576.0},
    {twd_small_from_double, twd_small_to_double, 17179869184.0},
};
enum { CONVERSIONS = sizeof conversions / sizeof conversions[0] };

/* A word comes back from double as it was; what lies between two words goes to the nearer one, a half away from 0. */
static void check_conversions(int32_t word, int32_t unused)
{
    (void)unused;
    const int32_t beyond = word < 0 ? -1 : 1;
    if (limited(word) != word || limited((int64_t)word + beyond) != (int64_t)word + beyond) return;
    for (size_t i = 0; i < CONVERSIONS; i++) {
        const double quarter = 0.25 * beyond / conversions[i].one;
        const double value = conversions[i].to_double(word);
        assert_true(value == (double)word / conversions[i].one);
        assert_word("from double", word, 0, conversions[i].from_double(value), word);
        assert_word("from double, a quarter on", word, 0, conversions[i].from_double(value + quarter), word);
        assert_word("from double, a half on", word, 0, conversions[i].from_double(value + 2 * quarter), word + beyond);
        assert_word("from double, three quarters on", word, 0, conversions[i].from_double(value + 3 * quarter),
                    word + beyond);
    }
}

static void conversions_round_to_nearest(void **state)
{
    (void)state;
    for_all_pairs(check_conversions);
}

/* Beyond the range a value becomes the last number; what is not finite becomes INT32_MIN. */
static void conversions_stay_in_range(void **state)
{
    static const double beyond[] = {1.0, 1.25, 1e3, 1e300, DBL_MAX};
    (void)state;
    for (size_t i = 0; i < CONVERSIONS; i++) {
        const double end = 2147483648.0 / conversions[i].one;
        for (size_t k = 0; k < sizeof beyond / sizeof beyond[0]; k++) {
            const double size = beyond[k] < 1e300 ? end * beyond[k] : beyond[k];
            assert_int_equal(conversions[i].from_double(size), INT32_MAX);
            assert_int_equal(conversions[i].from_double(-size), -INT32_MAX);
        }
        assert_int_equal(conversions[i].from_double((double)INFINITY), INT32_MIN);
        assert_int_equal(conversions[i].from_double(-(double)INFINITY), INT32_MIN);
        assert_int_equal(conversions[i].from_double((double)NAN), INT32_MIN);
        assert_int_equal(conversions[i].from_double(DBL_MIN), 0);
    }
}

/* Constants are rounded to nearest. Expected, by hand: 0.1 2^28 = 26843545.6, 1.3 2^24 = 21810380.8, 0.7 2^20 = 734003.2,
 * 0.01 2^34 = 171798691.84. */
static void constants_are_rounded_to_nearest(void **state)
{
    (void)state;
    assert_int_equal(TWD_NUM(0.1), 26843546);
    assert_int_equal(TWD_NUM(-0.1), -26843546);
    assert_int_equal(TWD_WIDE(-1.3), -21810381);
    assert_int_equal(TWD_RATE(0.7), 734003);
    assert_int_equal(TWD_SMALL(-0.01), -171798692);
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
        cmocka_unit_test(the_compiler_keeps_the_sign),
        cmocka_unit_test(conversions_round_to_nearest),
        cmocka_unit_test(conversions_stay_in_range),
        cmocka_unit_test(constants_are_rounded_to_nearest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
