#include "serial_port.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>

namespace twiddle::link
{

namespace
{

struct Speed {
    unsigned bits_per_s;
    speed_t code;
};

constexpr std::array<Speed, 13> speeds = {{{9600, B9600},
                                           {19200, B19200},
                                           {38400, B38400},
                                           {57600, B57600},
                                           {115200, B115200},
                                           {230400, B230400},
                                           {460800, B460800},
                                           {500000, B500000},
                                           {921600, B921600},
                                           {1000000, B1000000},
                                           {2000000, B2000000},
                                           {3000000, B3000000},
                                           {4000000, B4000000}}};

speed_t code_of(unsigned bits_per_s)
{
    const auto *const found =
        std::find_if(speeds.begin(), speeds.end(), [&](const Speed &speed) { return speed.bits_per_s == bits_per_s; });
    if (found == speeds.end()) throw std::invalid_argument("no serial port runs at " + std::to_string(bits_per_s));
    return found->code;
}

// Raw bytes both ways, and nothing of what was there before.
bool configure(int port, speed_t speed)
{
    termios settings{};
    if (::tcgetattr(port, &settings) != 0) return false;
    ::cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
    ::cfsetispeed(&settings, speed);
    ::cfsetospeed(&settings, speed);
    return ::tcsetattr(port, TCSANOW, &settings) == 0 && ::tcflush(port, TCIOFLUSH) == 0;
}

} // namespace

std::vector<unsigned> serial_speeds()
{
    std::vector<unsigned> all;
    for (const Speed &speed : speeds) {
        all.push_back(speed.bits_per_s);
    }
    return all;
}

SerialPort::SerialPort(std::filesystem::path path, unsigned bits_per_s)
    : path_(std::move(path)), port_(::open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC))
{
    const speed_t speed = code_of(bits_per_s);
    if (port_.number() < 0) throw LinkError("cannot open the port '" + path_.string() + "': " + std::strerror(errno));
    // Two programs at one port would each get half of the answers.
    if (::ioctl(port_.number(), TIOCEXCL) != 0 || !configure(port_.number(), speed))
        throw LinkError("'" + path_.string() + "' is no serial port: " + std::strerror(errno));
}

std::string SerialPort::name() const
{
    return "the chip at '" + path_.string() + "'";
}

int SerialPort::input() const
{
    return port_.number();
}

int SerialPort::output() const
{
    return port_.number();
}

std::string SerialPort::death()
{
    return {}; // a port does not say who is behind it
}

} // namespace twiddle::link
