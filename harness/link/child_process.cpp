#include "child_process.hpp"

#include "record/descriptor.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace twiddle::link
{

namespace
{

[[noreturn]] void fail(const std::string &what, int error)
{
    throw std::system_error(error, std::generic_category(), what);
}

// In the new process: become the program, or leave the reason in `reasons`. Only calls that may follow a fork.
[[noreturn]] void become(char *const *argv, const char *folder, int output, int reasons)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // whatever ends the owner
    ::setsid();                         // away from the terminal and its Ctrl-C
    const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (input >= 0 && ::dup2(input, STDIN_FILENO) >= 0 && ::dup2(output, STDOUT_FILENO) >= 0 &&
        ::dup2(output, STDERR_FILENO) >= 0 && ::chdir(folder) == 0)
        ::execvp(argv[0], argv);
    const int error = errno;
    (void)!::write(reasons, &error, sizeof error);
    ::_exit(EXIT_FAILURE);
}

std::string end_text(int status)
{
    if (WIFSIGNALED(status)) return std::string("was ended by the signal ") + ::strsignal(WTERMSIG(status));
    return "ended with status " + std::to_string(WEXITSTATUS(status));
}

int wait_for(pid_t process)
{
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

} // namespace

ChildProcess::ChildProcess(const std::vector<std::string> &command, const std::filesystem::path &folder,
                           const std::filesystem::path &output)
{
    const record::Descriptor words(::open(output.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR));
    if (words.number() < 0) fail("cannot write '" + output.string() + "'", errno);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("cannot make a pipe", errno);
    const record::Descriptor reading(ends[0]);
    record::Descriptor writing(ends[1]);

    std::vector<std::string> copies = command;
    std::vector<char *> argv;
    for (std::string &argument : copies) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    const pid_t process = ::fork();
    if (process < 0) fail("cannot start '" + command.front() + "'", errno);
    if (process == 0) become(argv.data(), folder.c_str(), words.number(), writing.number());

    writing = record::Descriptor(); // the other writing end closes when the program runs
    int error = 0;
    if (::read(reading.number(), &error, sizeof error) == sizeof error) {
        wait_for(process);
        fail("cannot run '" + command.front() + "'", error);
    }
    process_ = process;
}

ChildProcess::~ChildProcess()
{
    if (process_ == 0) return;
    ::kill(process_, SIGKILL);
    wait_for(process_);
}

const std::string &ChildProcess::end()
{
    int status = 0;
    if (process_ != 0 && ::waitpid(process_, &status, WNOHANG) == process_) {
        process_ = 0;
        end_ = end_text(status);
    }
    return end_;
}

} // namespace twiddle::link
