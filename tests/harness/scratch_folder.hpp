// scratch_folder.hpp: an empty folder that is gone after the test, and the text of an expected error.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace twiddle::test
{

class ScratchFolder
{
  public:
    ScratchFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "twiddle-test-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no scratch folder can be made");
        path_ = name;
    }
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder &) = delete;
    ScratchFolder &operator=(const ScratchFolder &) = delete;

    const std::filesystem::path &path() const
    {
        return path_;
    }

    // Write `text` to `name` (folders in it are made) and return its path.
    std::filesystem::path write(const std::string &name, const std::string &text) const
    {
        const auto file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << text;
        return file;
    }

  private:
    std::filesystem::path path_;
};

// What `function` throws as std::runtime_error; empty if it does not.
template <typename Function> std::string error_of(const Function &function)
{
    try {
        function();
    } catch (const std::runtime_error &error) {
        return error.what();
    }
    return "";
}

// One line that holds each of `parts`.
inline bool is_one_sentence_with(const std::string &text, std::initializer_list<std::string> parts)
{
    for (const auto &part : parts) {
        if (text.find(part) == std::string::npos) return false;
    }
    return !text.empty() && text.find('\n') == std::string::npos;
}

} // namespace twiddle::test
