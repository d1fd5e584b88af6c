// part_file.hpp: a text file that appears under its name only when it is whole.
//
// It is written as NAME.part and renamed by finish(); whatever ends the program before leaves NAME as it was.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace twiddle::record
{

// The name under which `path` is written until it is whole.
std::filesystem::path part_path(const std::filesystem::path &path);

class PartFile
{
  public:
    // Start an empty `path`.part. Throws std::runtime_error, naming the file, if it cannot be written; so do all below.
    explicit PartFile(std::filesystem::path path);

    // Go on with an existing `path`.part after its first `kept_bytes` bytes; what follows them is dropped.
    PartFile(std::filesystem::path path, std::uintmax_t kept_bytes);

    void write(std::string_view text);

    // Hand what was written to the operating system, so that it outlives this program.
    void flush();

    // Close the file and give it its name.
    void finish();

  private:
    void open(std::ios::openmode mode);

    // Throw if the last operation, before which errno was set to 0, has failed.
    void check();

    std::filesystem::path path_;
    std::ofstream file_;
};

// Write `text` as the file `path`. Throws as PartFile does.
void write_file(const std::filesystem::path &path, std::string_view text);

} // namespace twiddle::record
