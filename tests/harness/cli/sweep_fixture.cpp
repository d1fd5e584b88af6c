#include "sweep_fixture.hpp"

#include "record/json_file.hpp"

#include <gtest/gtest.h>

namespace twiddle::test
{

namespace fs = std::filesystem;

std::string manifest_text(int trials, const std::string &friction)
{
    return "trials = " + std::to_string(trials) +
           "\n[[runs]]\nobjects = [\"small-sphere\", \"large-cube\"]\nmodels = [\"cpg-c\", \"cpg-h\"]\nseeds = 1\n"
           "[[runs]]\nobjects = [\"small-sphere\"]\nmodels = [\"cpg-s\"]\ncentre = [false]\nseeds = 1\n"
           "variant = \"slippery\"\nset = { \"contact.friction\" = " +
           friction + " }\n";
}

const std::vector<std::string> folders = {"small-sphere/cpg-c/seed-1", "small-sphere/cpg-h/seed-1",
                                          "large-cube/cpg-c/seed-1", "large-cube/cpg-h/seed-1",
                                          "slippery/small-sphere/cpg-s-no-centre/seed-1"};

Outcome sweep(const fs::path &manifest, const fs::path &out, const std::string &more)
{
    return run_twiddle("sweep " + manifest.string() + " --out " + out.string() + " " + more);
}

std::map<std::string, std::string> files_below(const fs::path &folder)
{
    std::map<std::string, std::string> files;
    for (const auto &entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::string text = text_of(entry.path());
        if (entry.path().filename() == "run.json") {
            twiddle::record::Json run = twiddle::record::read_json(entry.path());
            run.erase("command");
            text = run.dump();
        }
        files[fs::relative(entry.path(), folder).string()] = text;
    }
    return files;
}

std::map<std::string, std::string> expected_files(const ScratchFolder &folder, const fs::path &manifest)
{
    const fs::path out = folder.path() / "whole";
    EXPECT_EQ(sweep(manifest, out, "--jobs 1").status, 0);
    return files_below(out);
}

} // namespace twiddle::test
