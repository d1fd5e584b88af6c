// pseudo_terminal.hpp: a pair of descriptors that looks like a serial port from one side.
#pragma once

#include "record/descriptor.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <fcntl.h>

namespace twiddle::test
{

// The chip's side of a serial line; the other side is the port at path().
class PseudoTerminal
{
  public:
    PseudoTerminal() : chip_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC))
    {
        if (chip_.number() < 0 || ::grantpt(chip_.number()) != 0 || ::unlockpt(chip_.number()) != 0)
            throw std::runtime_error("cannot make a pseudo-terminal");
        path_ = ::ptsname(chip_.number());
    }

    int chip() const
    {
        return chip_.number();
    }
    const std::string &path() const
    {
        return path_;
    }
    void close()
    {
        chip_ = record::Descriptor();
    }

  private:
    record::Descriptor chip_;
    std::string path_;
};

} // namespace twiddle::test
