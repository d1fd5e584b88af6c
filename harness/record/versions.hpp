// versions.hpp: what this program is made of, for the files that it writes.
#pragma once

#include <string>

namespace twiddle::record
{

// e.g. "0.1.0".
std::string version();

// The commit it was built from, with "-dirty" if files differed from it; "unknown" outside a git checkout.
std::string git_commit();

// e.g. "3.24".
std::string bullet_version();

// e.g. "GCC 12.2.0".
std::string compiler();

// One line for the head of every file, e.g. "twiddle 0.1.0 (commit 0123456789ab)".
std::string version_line();

} // namespace twiddle::record
