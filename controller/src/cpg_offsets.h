/* cpg_offsets.h: where a CPG's couplings find their oscillators. Not installed.
 *
 * Offsets in bytes save each tick the multiplication of an index; pointers would not survive a copy of the CPG. */
#ifndef TWIDDLE_CPG_OFFSETS_H
#define TWIDDLE_CPG_OFFSETS_H

#include <twiddle/cpg.h>

static inline struct twd_oscillator *at_offset(struct twd_cpg *cpg, uint16_t offset)
{
    return (struct twd_oscillator *)(void *)((unsigned char *)cpg->oscillator + offset);
}

static inline const struct twd_running_coupling *end_of_couplings(const struct twd_cpg *cpg)
{
    const void *const end = (const unsigned char *)cpg->coupling + cpg->couplings_end;
    return (const struct twd_running_coupling *)end;
}

#endif
