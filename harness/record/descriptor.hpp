// descriptor.hpp: an open file of the operating system, closed with its owner.
#pragma once

#include <utility>

#include <unistd.h>

namespace twiddle::record
{

class Descriptor
{
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number)
    {
    }
    Descriptor(Descriptor &&other) noexcept : number_(std::exchange(other.number_, -1))
    {
    }
    Descriptor &operator=(Descriptor &&other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }

    // Negative if nothing is open.
    int number() const
    {
        return number_;
    }

  private:
    int number_ = -1;
};

} // namespace twiddle::record
