// connection.hpp: a chip at the other end of two byte streams.
#pragma once

#include <stdexcept>
#include <string>

namespace twiddle::link
{

// A chip cannot be reached, has fallen silent or says what it should not: one sentence.
class LinkError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

class Connection
{
  public:
    virtual ~Connection() = default;

    // The chip in a sentence, e.g. "the emulated microbit".
    virtual std::string name() const = 0;

    // Descriptors to read from and to write to, none of which blocks.
    virtual int input() const = 0;
    virtual int output() const = 0;

    // Why nothing more can come, as the rest of a sentence that begins with the name, e.g. "has ended: its QEMU ended
    // with status 1"; empty while the chip may live.
    virtual std::string death() = 0;
};

} // namespace twiddle::link
