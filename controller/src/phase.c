#include <twiddle/phase.h>

#if defined(TWD_NUMBER_FIXED) && defined(TWD_MULTIPLIES_BY_PIECES)
twd_num twd_cos(twd_phase phase)
{
    return twd_cos_inline(phase);
}
#else
/* Everything is inline; ISO C wants a declaration in every file. */
typedef twd_phase twd_phase_is_inline;
#endif
