#include "part_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace twiddle::record
{

std::filesystem::path part_path(const std::filesystem::path &path)
{
    std::filesystem::path part = path;
    part += ".part";
    return part;
}

PartFile::PartFile(std::filesystem::path path) : path_(std::move(path))
{
    open(std::ios::binary | std::ios::trunc);
}

PartFile::PartFile(std::filesystem::path path, std::uintmax_t kept_bytes) : path_(std::move(path))
{
    std::error_code error;
    std::filesystem::resize_file(part_path(path_), kept_bytes, error);
    if (error) throw std::runtime_error("cannot write '" + part_path(path_).string() + "': " + error.message());
    open(std::ios::binary | std::ios::app);
}

void PartFile::write(std::string_view text)
{
    errno = 0;
    file_.write(text.data(), static_cast<std::streamsize>(text.size()));
    check();
}

void PartFile::flush()
{
    errno = 0;
    file_.flush();
    check();
}

void PartFile::finish()
{
    errno = 0;
    file_.close();
    check();
    std::error_code error;
    std::filesystem::rename(part_path(path_), path_, error);
    if (error) throw std::runtime_error("cannot write '" + path_.string() + "': " + error.message());
}

void PartFile::open(std::ios::openmode mode)
{
    errno = 0;
    file_.open(part_path(path_), mode);
    check();
}

void PartFile::check()
{
    if (file_) return;
    const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    throw std::runtime_error("cannot write '" + part_path(path_).string() + "'" + reason);
}

void write_file(const std::filesystem::path &path, std::string_view text)
{
    PartFile file(path);
    file.write(text);
    file.finish();
}

} // namespace twiddle::record
