// emulator.hpp: a chip in QEMU, with an image that reads and writes the FIFOs to-chip and from-chip
// (firmware/agent/main_files.c).
#pragma once

#include "child_process.hpp"
#include "connection.hpp"
#include "record/descriptor.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace twiddle::link
{

// "microbit", "mps2-an386", "virt".
std::vector<std::string> emulated_boards();

// A new folder, which goes with its owner.
class TemporaryFolder
{
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    const std::filesystem::path &path() const;

  private:
    std::filesystem::path path_;
};

class Emulator : public Connection
{
  public:
    // Start `image` on `board`, one of emulated_boards(). Throws LinkError if QEMU is not there or a FIFO cannot be
    // made.
    Emulator(std::string board, const std::filesystem::path &image);

    std::string name() const override;
    int input() const override;
    int output() const override;
    std::string death() override;

  private:
    record::Descriptor open_fifo(const std::string &name, int flags) const;
    std::filesystem::path output_path() const;
    std::string last_words() const;

    std::string board_;
    TemporaryFolder folder_;
    record::Descriptor to_chip_;
    record::Descriptor from_chip_;
    std::optional<ChildProcess> qemu_; // after the constructor always there
};

} // namespace twiddle::link
