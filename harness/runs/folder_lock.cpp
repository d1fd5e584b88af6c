#include "folder_lock.hpp"

#include "stop_request.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>

namespace twiddle::runs
{

namespace
{

// A worker whose sweep was killed ends after the trial in hand, which takes up to a second in the slowest stepper.
constexpr std::chrono::milliseconds longest_wait{5000};
constexpr std::chrono::milliseconds retry_interval{20};

bool is_taken(int folder)
{
    return ::flock(folder, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR);
}

} // namespace

FolderLock::FolderLock(const std::filesystem::path &folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    if (folder_.number() < 0)
        throw std::runtime_error("cannot open '" + folder.string() + "': " + std::strerror(errno));
    const auto end = std::chrono::steady_clock::now() + longest_wait;
    while (is_taken(folder_.number())) {
        if (stop_signal() != 0 || std::chrono::steady_clock::now() > end)
            throw std::runtime_error("another program is at work in '" + folder.string() + "'");
        std::this_thread::sleep_for(retry_interval);
    }
}

} // namespace twiddle::runs
