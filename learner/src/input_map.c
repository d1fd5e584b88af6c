#include <twiddle/input_map.h>

#include <twiddle/elementary.h>

#define FIRST_PREFERRED_M TWD_NUM_CONSTANT(0.024, 6442451)
#define SPACING_M TWD_NUM_CONSTANT(0.002, 536871)
#define FOUR_WIDTHS_M TWD_NUM_CONSTANT(0.008, 2147484)

/* With units one tuning width apart, the squared responses of an endless row of unit amplitude sum to
 * sum_k exp(-(k + d)^2), which is sqrt(pi) to within 2e-4 whatever the offset d. */
#define UNIT_SQUARED_NORM TWD_WIDE_CONSTANT(1.7724538509055160, 29736841)

/* Square root of a value in [0, 60], by Newton's method from above, where the estimates fall until they are as close as
 * they get. */
static twd_wide square_root(twd_wide value)
{
    if (value <= TWD_WIDE(0)) return TWD_WIDE(0);
    twd_wide root = value > TWD_WIDE(1) ? value : TWD_WIDE(1);
    for (;;) {
        const twd_wide next = twd_wide_half(root + twd_wide_div(value, root));
        if (next >= root) return root;
        root = next;
    }
}

void twd_input_map(enum twd_shape shape, twd_num size_m, twd_wide squared_norm, twd_num *input)
{
    const twd_num size = twd_clamp(size_m, TWD_NUM(0), TWD_NUM_CONSTANT(0.1, 26843546));
    const twd_wide norm = twd_wide_clamp(squared_norm, TWD_WIDE(0), TWD_WIDE(100));
    const twd_num amplitude = twd_num_of_wide(square_root(twd_wide_div(norm, UNIT_SQUARED_NORM)));

    for (int row = 0; row < TWD_SHAPES; row++) {
        twd_num *const response = input + (ptrdiff_t)row * TWD_INPUT_SIZES;
        twd_num preferred = FIRST_PREFERRED_M;
        for (int unit = 0; unit < TWD_INPUT_SIZES; unit++) {
            /* A distance of 8 widths is as good as none nearer: exp(-32). In fours, for number formats that do not
             * reach 64. */
            const twd_num fours = twd_clamp(twd_div(size - preferred, FOUR_WIDTHS_M), TWD_NUM(-2), TWD_NUM(2));
            const twd_wide half_square = twd_wide_mul(TWD_NUM(4), twd_wide_product(fours, fours + fours));
            const twd_num tuning = twd_exp_negative(half_square);
            response[unit] = row == (int)shape ? twd_mul(amplitude, tuning) : TWD_NUM(0);
            preferred += SPACING_M;
        }
    }
}
