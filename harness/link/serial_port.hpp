// serial_port.hpp: a chip at a serial port, or at anything else that the system shows as a terminal.
#pragma once

#include "connection.hpp"
#include "record/descriptor.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::link
{

// The speeds that a port can be set to, in bit/s, ascending.
std::vector<unsigned> serial_speeds();

class SerialPort : public Connection
{
  public:
    // Open the port with 8 data bits, no parity, one stop bit, no flow control. Throws LinkError; std::invalid_argument
    // for a speed that is none of serial_speeds().
    SerialPort(std::filesystem::path path, unsigned bits_per_s);

    std::string name() const override;
    int input() const override;
    int output() const override;
    std::string death() override;

  private:
    std::filesystem::path path_;
    record::Descriptor port_;
};

} // namespace twiddle::link
