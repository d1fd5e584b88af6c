// usage_error.hpp: a command that was used wrongly, told from one that failed.
#pragma once

#include <stdexcept>

namespace twiddle::runs
{

// An unknown name, a value out of range, a folder that must not be touched: one sentence for the user.
class UsageError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

} // namespace twiddle::runs
