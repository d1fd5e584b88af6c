// What the emulator's starter makes of a QEMU that is missing, fails, dies or hangs; scripts stand in for QEMU. The
// real one is in test_emulated_training.
#include "../scratch_folder.hpp"
#include "link/emulator.hpp"
#include "link/frame_link.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <sstream>
#include <thread>

#include <sys/stat.h>
#include <unistd.h>

namespace
{

using namespace twiddle::link;
using twiddle::test::error_of;
using twiddle::test::ScratchFolder;
namespace fs = std::filesystem;

// A PATH, for as long as it lives, on which qemu-system-arm is the given shell script.
class Stage
{
  public:
    explicit Stage(const std::string &script) : old_path_(std::getenv("PATH"))
    {
        const fs::path program = folder_.write("qemu-system-arm", "#!/bin/sh\n" + script + "\n");
        ::chmod(program.c_str(), S_IRWXU);
        ::setenv("PATH", (folder_.path().string() + ":" + old_path_).c_str(), 1);
    }
    ~Stage()
    {
        ::setenv("PATH", old_path_.c_str(), 1);
    }
    Stage(const Stage &) = delete;
    Stage &operator=(const Stage &) = delete;

  private:
    ScratchFolder folder_;
    std::string old_path_;
};

std::string greeting_complaint()
{
    return error_of([] {
        FrameLink link(std::make_unique<Emulator>("microbit", "image"));
        link.greet();
    });
}

std::string text_in(const fs::path &path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// QEMU is asked for the board, with semihosting and the image's absolute path, in the folder of the FIFOs.
TEST(Emulator, qemu_is_asked_for_the_board)
{
    const ScratchFolder folder;
    const std::string seen = (folder.path() / "seen").string();
    const Stage stage("echo \"$@\" >" + seen + "; ls >>" + seen);
    (void)greeting_complaint();
    const std::string text = text_in(seen);
    EXPECT_NE(text.find("-M microbit "), std::string::npos) << text;
    EXPECT_NE(text.find("-semihosting-config enable=on,target=native"), std::string::npos) << text;
    EXPECT_NE(text.find("-kernel " + fs::absolute("image").string()), std::string::npos) << text;
    EXPECT_NE(text.find("\nfrom-chip\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nto-chip\n"), std::string::npos) << text;
}

// A QEMU that ends is told at once, with its status and its words.
TEST(Emulator, end_of_qemu_is_told_at_once)
{
    const auto start = std::chrono::steady_clock::now();
    const Stage stage("echo 'no such board' >&2; exit 3");
    EXPECT_EQ(greeting_complaint(),
              "the emulated microbit has gone: its QEMU ended with status 3, saying: no such board");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

// One that is killed, too, also when it had the FIFOs open.
TEST(Emulator, killed_qemu_is_told_at_once)
{
    const auto start = std::chrono::steady_clock::now();
    const Stage stage("exec 3>from-chip 4<to-chip; kill -KILL $$");
    EXPECT_EQ(greeting_complaint(), "the emulated microbit has gone: its QEMU was ended by the signal Killed");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

// Where there is no QEMU, the sentence says how to get it.
TEST(Emulator, missing_qemu_is_told)
{
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nonexistent", 1);
    const std::string sentence = greeting_complaint();
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(sentence, "cannot run 'qemu-system-arm': No such file or directory, which emulates microbit; "
                        "scripts/install-deps installs it");
}

// A QEMU that hangs goes with its owner, and so does its folder.
TEST(Emulator, hanging_qemu_goes_with_its_owner)
{
    const ScratchFolder folder;
    const std::string seen = (folder.path() / "seen").string();
    const Stage stage("echo $$ >" + seen + ".part; pwd >>" + seen + ".part; mv " + seen + ".part " + seen +
                      "; trap '' TERM INT; exec sleep 60");
    pid_t process = 0;
    std::string place;
    {
        const Emulator emulator("microbit", "image");
        while (!fs::exists(seen)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        std::istringstream text(text_in(seen));
        text >> process >> place;
        EXPECT_EQ(::kill(process, 0), 0);
        EXPECT_TRUE(fs::is_directory(place));
        EXPECT_NE(::getsid(process), ::getsid(0)); // out of reach of the terminal's Ctrl-C
    }
    EXPECT_NE(::kill(process, 0), 0);
    EXPECT_FALSE(fs::exists(place));
}

} // namespace
