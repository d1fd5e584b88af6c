// folder_lock.hpp: one process at a time in a run's folder.
#pragma once

#include "record/descriptor.hpp"

#include <filesystem>

namespace twiddle::runs
{

// Holds the folder while it lives; the operating system frees the folder however the process ends. Nothing is written.
class FolderLock
{
  public:
    // Waits for some seconds for a process that is about to end. Throws std::runtime_error if the folder stays taken,
    // or cannot be opened. A file system without locks gives none: then the user sees to it that nobody else is there.
    explicit FolderLock(const std::filesystem::path &folder);

  private:
    record::Descriptor folder_;
};

} // namespace twiddle::runs
