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

// Run `twiddle ARGUMENTS` through a shell, with `input` on standard input. The environment's TWIDDLE_MODELS
// is not passed on.
Outcome run_twiddle(const std::string &arguments, const std::string &input = "");

// The same where no file can grow beyond `blocks` of 512 bytes: a write beyond fails as on a full disk, in the middle
// of what is written.
Outcome run_twiddle_on_full_disk(const std::string &arguments, int blocks);

std::string text_of(const std::filesystem::path &path);

// Whether `text` is one line that starts with "twiddle: ".
bool is_one_complaint(const std::string &text);

} // namespace twiddle::test
