// sweep_fixture.hpp: a small sweep, and what it leaves.
#pragma once

#include "../scratch_folder.hpp"
#include "program.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace twiddle::test
{

// A manifest of five runs: two objects, two models, and one variant, with this contact friction.
std::string manifest_text(int trials, const std::string &friction = "0.4");

// The folders of its runs, by index.
extern const std::vector<std::string> folders;

// Run `twiddle sweep MANIFEST --out OUT MORE`.
Outcome sweep(const std::filesystem::path &manifest, const std::filesystem::path &out, const std::string &more = "");

// The bytes of all files below `folder` by their names; run.json only as far as it does not name the folder itself.
std::map<std::string, std::string> files_below(const std::filesystem::path &folder);

// The files of an uninterrupted sweep with one job.
std::map<std::string, std::string> expected_files(const ScratchFolder &folder, const std::filesystem::path &manifest);

} // namespace twiddle::test
