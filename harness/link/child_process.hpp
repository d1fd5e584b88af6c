// child_process.hpp: another program, which ends with its owner.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace twiddle::link
{

class ChildProcess
{
  public:
    // Start `command` in `folder`, without input, its output and errors going to the file `output`. Ctrl-C does not
    // reach it. Throws std::system_error if it cannot be started, e.g. since there is no such program.
    ChildProcess(const std::vector<std::string> &command, const std::filesystem::path &folder,
                 const std::filesystem::path &output);
    ~ChildProcess();
    ChildProcess(const ChildProcess &) = delete;
    ChildProcess &operator=(const ChildProcess &) = delete;

    // How it ended, as "ended with status 1"; empty while it runs.
    const std::string &end();

  private:
    pid_t process_ = 0; // 0 once it has ended
    std::string end_;
};

} // namespace twiddle::link
