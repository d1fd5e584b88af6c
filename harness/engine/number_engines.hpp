// number_engines.hpp: the engines by their build of the C library; each is compiled from the same sources.
#pragma once

#include "engine.hpp"

namespace twiddle::engine
{

namespace twd_float
{
extern const Engine engine;
}
namespace twd_double
{
extern const Engine engine;
}
namespace twd_fixed
{
extern const Engine engine;
}

} // namespace twiddle::engine
