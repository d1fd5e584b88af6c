#include "text_file.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace twiddle::settings
{

std::string read_text_file(const std::filesystem::path &path)
{
    if (!std::filesystem::exists(path)) throw std::runtime_error(path.string() + ": there is no such file");
    if (!std::filesystem::is_regular_file(path)) throw std::runtime_error(path.string() + ": this is not a file");
    std::ifstream stream(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) throw std::runtime_error(path.string() + ": the file cannot be read");
    return text;
}

} // namespace twiddle::settings
