// errors.hpp: the two ways in which a command can fail. Both are one sentence on standard error.
#pragma once

#include <stdexcept>

namespace twiddle::cli
{

constexpr int exit_failure = 1;   // any other exception
constexpr int exit_wrong_use = 2; // UsageError

// The command was used wrongly: an unknown name, a value out of range, a folder that must not be touched.
class UsageError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

} // namespace twiddle::cli
