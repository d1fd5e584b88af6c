// number.hpp: the C library's numbers as the harness reads and writes them.
#pragma once

#include <twiddle/convert.h>

namespace twiddle::experiment
{

// How a number of the library is shown in files: as it is, or the double that a fixed-point word stands for.
#if defined(TWD_NUMBER_FIXED)
using Shown = double;
#else
using Shown = twd_num;
#endif

inline Shown shown_num(twd_num value)
{
    return static_cast<Shown>(twd_num_to_double(value));
}

inline Shown shown_wide(twd_wide value)
{
    return static_cast<Shown>(twd_wide_to_double(value));
}

} // namespace twiddle::experiment
