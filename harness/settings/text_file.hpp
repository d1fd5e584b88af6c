// text_file.hpp: a whole text file, or one sentence why not.
#pragma once

#include <filesystem>
#include <string>

namespace twiddle::settings
{

// The contents of `path`. Throws std::runtime_error that names the file.
std::string read_text_file(const std::filesystem::path &path);

} // namespace twiddle::settings
