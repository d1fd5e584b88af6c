#include "program.hpp"

#include "../scratch_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <sys/wait.h>

namespace twiddle::test
{

namespace
{

// Run `twiddle ARGUMENTS` after the shell commands `before`, which each end with a semicolon.
Outcome run_after(const std::string &before, const std::string &arguments, const std::string &input)
{
    const ScratchFolder folder;
    const std::string in = folder.write("in", input).string();
    const std::string out = (folder.path() / "out").string();
    const std::string err = (folder.path() / "err").string();
    const std::string command = "unset TWIDDLE_MODELS; " + before + " '" TWIDDLE_PROGRAM "' " + arguments + " <" + in +
                                " >" + out + " 2>" + err;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

} // namespace

Outcome run_twiddle(const std::string &arguments, const std::string &input)
{
    return run_after("", arguments, input);
}

Outcome run_twiddle_on_full_disk(const std::string &arguments, int blocks)
{
    // Without the trap, the signal would end the program before it can say anything.
    return run_after("trap '' XFSZ; ulimit -f " + std::to_string(blocks) + ";", arguments, "");
}

std::string text_of(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool is_one_complaint(const std::string &text)
{
    return text.rfind("twiddle: ", 0) == 0 && text.back() == '\n' && std::count(text.begin(), text.end(), '\n') == 1;
}

} // namespace twiddle::test
