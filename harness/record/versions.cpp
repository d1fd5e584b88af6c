#include "versions.hpp"

#include "git_commit.hpp"

namespace twiddle::record
{

std::string version()
{
    return TWIDDLE_VERSION;
}

std::string git_commit()
{
    return TWIDDLE_GIT_COMMIT;
}

std::string bullet_version()
{
    return TWIDDLE_BULLET_VERSION;
}

std::string compiler()
{
#if defined(__clang__)
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string version_line()
{
    return "twiddle " + version() + " (commit " + git_commit() + ")";
}

} // namespace twiddle::record
