// own_program.hpp: where this program is, and how it was called.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::cli
{

// The folder that this program is in.
std::filesystem::path own_folder();

// The arguments as one line that a shell reads back as the same.
std::string shell_line(const std::vector<std::string> &arguments);

} // namespace twiddle::cli
