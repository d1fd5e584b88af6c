#include <twiddle/oscillator.h>

#include <twiddle/phase.h>

twd_num twd_oscillator_output_with_centre(const struct twd_oscillator *oscillator)
{
    return oscillator->centre.value + twd_mul(oscillator->amplitude.value, twd_cos(oscillator->phase));
}

twd_num twd_oscillator_output_without_centre(const struct twd_oscillator *oscillator)
{
    return twd_mul(oscillator->amplitude.value, TWD_NUM(1) + twd_cos(oscillator->phase));
}
