#include <twiddle/input_map.h>

#include <twiddle/elementary.h>

#define FIRST_PREFERRED_M TWD_NUM(0.024)
#define SPACING_M TWD_NUM(0.002)
#define WIDTH_M TWD_NUM(0.002)

/* With units one tuning width apart, the squared responses of an endless row of unit amplitude sum to
 * sum_k exp(-(k + d)^2), which is sqrt(pi) to within 2e-4 whatever the offset d. */
#define UNIT_SQUARED_NORM TWD_NUM(1.7724538509055160)

/* Square root of a value in [0, 1e4], by Newton's method from above, where the estimates fall until they are as close as they get. */
static twd_num square_root(twd_num value)
{
    if (value <= TWD_NUM(0)) return TWD_NUM(0);
    twd_num root = value > TWD_NUM(1) ? value : TWD_NUM(1);
    for (;;) {
        const twd_num next = twd_mul(TWD_NUM(0.5), root + twd_div(value, root));
        if (next >= root) return root;
        root = next;
    }
}

void twd_input_map(enum twd_shape shape, twd_num size_m, twd_num squared_norm, twd_num *input)
{
    const twd_num size = twd_clamp(size_m, TWD_NUM(0), TWD_NUM(0.1));
    const twd_num norm = twd_clamp(squared_norm, TWD_NUM(0), TWD_NUM(100));
    const twd_num amplitude = square_root(twd_div(norm, UNIT_SQUARED_NORM));

    for (int row = 0; row < TWD_SHAPES; row++) {
        twd_num *const response = input + (ptrdiff_t)row * TWD_INPUT_SIZES;
        twd_num preferred = FIRST_PREFERRED_M;
        for (int unit = 0; unit < TWD_INPUT_SIZES; unit++) {
            const twd_num distance = twd_div(size - preferred, WIDTH_M);
            const twd_num tuning = twd_exp_negative(twd_mul(TWD_NUM(0.5), twd_mul(distance, distance)));
            response[unit] = row == (int)shape ? twd_mul(amplitude, tuning) : TWD_NUM(0);
            preferred += SPACING_M;
        }
    }
}
