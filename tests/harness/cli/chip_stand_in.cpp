// chip_stand_in: a chip on this machine, at a serial port that is a pseudo-terminal, well or with a fault.
//
//     chip_stand_in PORT [FAULT ANSWERS]
//
// makes PORT a link to the pseudo-terminal and serves an agent there until the port has been opened and closed. FAULT
// comes after so many answers: `silent` answers no more, `damage` changes a bit of each answer, `die` ends the program.
// When it comes, the file PORT.fault is made.
#include "../pseudo_terminal.hpp"
#include "agent/agent_server.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace
{

class Chip
{
  public:
    Chip(std::string port, std::string fault, long answers)
        : port_(std::move(port)), fault_(std::move(fault)), answers_(answers)
    {
        // Renamed into its place, so that a test that waits for the port finds it whole.
        const std::string part = port_ + ".part";
        std::filesystem::create_symlink(terminal_.path(), part);
        std::filesystem::rename(part, port_);
    }

    std::size_t read(std::uint8_t *bytes, std::size_t capacity) const
    {
        const ssize_t count = ::read(terminal_.chip(), bytes, capacity);
        return count > 0 ? static_cast<std::size_t>(count) : 0;
    }

    // One answer.
    bool write(const std::uint8_t *bytes, std::size_t count)
    {
        if (fault_.empty() || answers_-- > 0) return pass_on(bytes, count);
        std::ofstream(port_ + ".fault") << fault_;
        if (fault_ == "die") ::_exit(0);
        std::vector<std::uint8_t> answer(bytes, bytes + count);
        answer.back() ^= 1U;
        return fault_ == "silent" || pass_on(answer.data(), count);
    }

  private:
    bool pass_on(const std::uint8_t *bytes, std::size_t count) const
    {
        return ::write(terminal_.chip(), bytes, count) == static_cast<ssize_t>(count);
    }

    twiddle::test::PseudoTerminal terminal_;
    std::string port_;
    std::string fault_;
    long answers_; // left before the fault
};

std::size_t read(void *context, std::uint8_t *bytes, std::size_t capacity)
{
    return static_cast<Chip *>(context)->read(bytes, capacity);
}

bool write(void *context, const std::uint8_t *bytes, std::size_t count)
{
    return static_cast<Chip *>(context)->write(bytes, count);
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 2 && argc != 4) {
        std::cerr << "usage: chip_stand_in PORT [FAULT ANSWERS]\n";
        return 2;
    }
    Chip chip(argv[1], argc == 4 ? argv[2] : "", argc == 4 ? std::stol(argv[3]) : 0);
    const twd_byte_link link = {read, write, &chip};
    static twd_agent_server server;
    twd_agent_server_start(&server);
    twd_agent_server_run(&server, &link);
    return 0;
}
