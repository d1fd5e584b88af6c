#include "../pseudo_terminal.hpp"
#include "../scratch_folder.hpp"
#include "link/serial_port.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace
{

using namespace twiddle::link;
using twiddle::test::error_of;
using twiddle::test::PseudoTerminal;
using twiddle::test::ScratchFolder;

std::string complaint(const std::filesystem::path &path)
{
    return error_of([&] { const SerialPort port(path, 115200); });
}

void expect_all_bytes_pass(int from, int to)
{
    std::array<std::uint8_t, 256> sent{};
    std::iota(sent.begin(), sent.end(), std::uint8_t{0});
    ASSERT_EQ(::write(from, sent.data(), sent.size()), static_cast<ssize_t>(sent.size()));
    std::vector<std::uint8_t> got;
    pollfd source = {to, POLLIN, 0};
    while (got.size() < sent.size() && ::poll(&source, 1, 2000) > 0) {
        std::array<std::uint8_t, 256> some{};
        const ssize_t count = ::read(to, some.data(), some.size());
        ASSERT_GT(count, 0);
        got.insert(got.end(), some.begin(), some.begin() + count);
    }
    EXPECT_EQ(got, std::vector<std::uint8_t>(sent.begin(), sent.end()));
}

// Every byte passes both ways as it is, also line ends, Ctrl-C and XOFF, and nothing is echoed.
TEST(SerialPort, every_byte_passes_as_it_is)
{
    const PseudoTerminal terminal;
    const SerialPort port(terminal.path(), 115200);
    expect_all_bytes_pass(port.output(), terminal.chip());
    expect_all_bytes_pass(terminal.chip(), port.input());
    EXPECT_EQ(port.name(), "the chip at '" + terminal.path() + "'");
}

// The port runs at the speed that was asked for. Expected: the system's own reading of it.
TEST(SerialPort, speed_is_set)
{
    const PseudoTerminal terminal;
    for (const auto &[bits_per_s, code] : {std::pair{9600U, B9600}, std::pair{1000000U, B1000000}}) {
        const SerialPort port(terminal.path(), bits_per_s);
        termios settings{};
        ASSERT_EQ(::tcgetattr(port.input(), &settings), 0);
        EXPECT_EQ(::cfgetispeed(&settings), code);
        EXPECT_EQ(::cfgetospeed(&settings), code);
        EXPECT_EQ(settings.c_cflag & (CSIZE | CSTOPB | PARENB | CRTSCTS), static_cast<tcflag_t>(CS8));
    }
    EXPECT_THROW(SerialPort(terminal.path(), 12345), std::invalid_argument);
}

// What is not there, and what is no terminal, is named.
TEST(SerialPort, what_is_no_port_is_named)
{
    const ScratchFolder folder;
    const std::string file = folder.write("file", "text").string();
    EXPECT_EQ(complaint("/nonexistent/port"), "cannot open the port '/nonexistent/port': No such file or directory");
    EXPECT_EQ(complaint(file).find("'" + file + "' is no serial port"), 0U) << complaint(file);
    EXPECT_EQ(complaint("/dev/null").find("'/dev/null' is no serial port"), 0U);
}

} // namespace
