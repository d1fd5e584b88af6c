#include "emulator.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

namespace twiddle::link
{

namespace
{

namespace fs = std::filesystem;

// How QEMU is asked for a board.
struct Board {
    const char *name;
    const char *program;
    std::vector<std::string> options;
};

const std::vector<Board> &boards()
{
    static const std::vector<Board> all = {{"microbit", "qemu-system-arm", {}},
                                           {"mps2-an386", "qemu-system-arm", {}},
                                           {"virt", "qemu-system-riscv32", {"-bios", "none"}}};
    return all;
}

std::vector<std::string> qemu_command(const std::string &name, const fs::path &image)
{
    const auto board = std::find_if(boards().begin(), boards().end(), [&](const Board &b) { return b.name == name; });
    if (board == boards().end()) throw std::invalid_argument("no emulator knows the board '" + name + "'");
    std::vector<std::string> command = {board->program, "-M", name};
    command.insert(command.end(), board->options.begin(), board->options.end());
    command.insert(command.end(), {"-display", "none", "-monitor", "none", "-serial", "null", "-semihosting-config",
                                   "enable=on,target=native", "-kernel", fs::absolute(image).string()});
    return command;
}

[[noreturn]] void fail(const std::string &what)
{
    throw LinkError(what + ": " + std::strerror(errno));
}

} // namespace

std::vector<std::string> emulated_boards()
{
    std::vector<std::string> names;
    for (const Board &board : boards()) {
        names.emplace_back(board.name);
    }
    return names;
}

TemporaryFolder::TemporaryFolder()
{
    std::string pattern = (fs::temp_directory_path() / "twiddle-chip-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) fail("cannot make the folder '" + pattern + "'");
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

const fs::path &TemporaryFolder::path() const
{
    return path_;
}

// QEMU finds both FIFOs open: to-chip for both directions, so that it waits for our words rather than meet their end;
// from-chip for reading alone, so that its end shows.
Emulator::Emulator(std::string board, const fs::path &image)
    : board_(std::move(board)), to_chip_(open_fifo("to-chip", O_RDWR)), from_chip_(open_fifo("from-chip", O_RDONLY))
{
    try {
        qemu_.emplace(qemu_command(board_, image), folder_.path(), output_path());
    } catch (const std::system_error &error) {
        throw LinkError(std::string(error.what()) + ", which emulates " + board_ +
                        "; scripts/install-deps installs it");
    }
}

std::string Emulator::name() const
{
    return "the emulated " + board_;
}

int Emulator::input() const
{
    return from_chip_.number();
}

int Emulator::output() const
{
    return to_chip_.number();
}

std::string Emulator::death()
{
    const std::string &end = qemu_->end();
    if (end.empty()) return {};
    const std::string words = last_words();
    return "has gone: its QEMU " + end + (words.empty() ? "" : ", saying: " + words);
}

record::Descriptor Emulator::open_fifo(const std::string &name, int flags) const
{
    const fs::path path = folder_.path() / name;
    if (::mkfifo(path.c_str(), S_IRUSR | S_IWUSR) != 0) fail("cannot make the FIFO '" + path.string() + "'");
    record::Descriptor fifo(::open(path.c_str(), flags | O_NONBLOCK | O_CLOEXEC));
    if (fifo.number() < 0) fail("cannot open the FIFO '" + path.string() + "'");
    return fifo;
}

fs::path Emulator::output_path() const
{
    return folder_.path() / "output";
}

// What QEMU and its image have said, in one line.
std::string Emulator::last_words() const
{
    std::ifstream file(output_path());
    std::string words;
    for (std::string line; std::getline(file, line);) {
        if (!words.empty()) words += ' ';
        words += line;
    }
    return words;
}

} // namespace twiddle::link
