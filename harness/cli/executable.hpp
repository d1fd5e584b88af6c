// executable.hpp: where this program is, and its siblings for other number types.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::cli
{

// The number type of this executable's C library, e.g. "float".
std::string own_number();

// The folder that this executable is in.
std::filesystem::path own_folder();

// If `number` is another type, become the executable that is built for it, with the same arguments, and do not return.
// Throws std::runtime_error if it is not there.
void hand_over(const std::string &number, const std::vector<std::string> &arguments);

// The arguments as one line that a shell reads back as the same.
std::string shell_line(const std::vector<std::string> &arguments);

} // namespace twiddle::cli
