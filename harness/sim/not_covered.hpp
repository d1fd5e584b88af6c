// not_covered.hpp: what a stepper refuses.
#pragma once

#include <stdexcept>

namespace twiddle::sim
{

// The stepper does not cover this hand or set-up; the sentence names the one that does.
class NotCovered : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

} // namespace twiddle::sim
