#include "executable.hpp"

#include <twiddle/number.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <unistd.h>

namespace twiddle::cli
{

namespace
{

constexpr const char *default_number = "float"; // whose executable is plainly "twiddle"

std::string shell_word(const std::string &argument)
{
    const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=./,:+@%";
    if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) return argument;
    std::string quoted = "'";
    for (const char c : argument) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + "'";
}

} // namespace

std::string own_number()
{
    return TWD_NUMBER_NAME;
}

std::filesystem::path own_folder()
{
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

void hand_over(const std::string &number, const std::vector<std::string> &arguments)
{
    if (number == own_number()) return;
    const std::string name = number == default_number ? "twiddle" : "twiddle-" + number;
    const std::string path = (own_folder() / name).string();

    std::vector<std::string> copies = arguments;
    std::vector<char *> argv;
    for (std::string &argument : copies) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    ::execv(path.c_str(), argv.data());
    throw std::runtime_error("cannot run '" + path + "', which is built for number type " + number + ": " +
                             std::strerror(errno));
}

std::string shell_line(const std::vector<std::string> &arguments)
{
    std::string line;
    for (const std::string &argument : arguments) {
        if (!line.empty()) line += ' ';
        line += shell_word(argument);
    }
    return line;
}

} // namespace twiddle::cli
