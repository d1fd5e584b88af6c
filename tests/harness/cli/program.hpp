// program.hpp: runs the twiddle program as a user would.
#pragma once

#include <filesystem>
#include <string>

namespace twiddle::test
{

struct Outcome {
    int status = 0;     // exit status
    std::string output; // on standard output
    std::string error;  // on standard error
};

// Run `twiddle ARGUMENTS` through a shell, with `input` on standard input. The environment's TWIDDLE_MODELS is not passed on.
Outcome run_twiddle(const std::string &arguments, const std::string &input = "");

std::string text_of(const std::filesystem::path &path);

// Whether `text` is one line that starts with "twiddle: ".
bool is_one_complaint(const std::string &text);

} // namespace twiddle::test
