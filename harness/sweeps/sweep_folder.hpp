// sweep_folder.hpp: the folder of a sweep, and the one file in it that is no run's: sweep.json.
#pragma once

#include "sweep_manifest.hpp"

#include <filesystem>

namespace twiddle::sweeps
{

// Make `folder`, with missing ones around it. Throws std::runtime_error with one sentence.
void make_folder(const std::filesystem::path &folder);

// Make `folder` the folder of the sweep `plan` by writing its sweep.json; several processes may do so at once. One that
// is the folder of the same sweep stays as it is. Throws UsageError, with nothing changed, if it holds anything else or
// a sweep.json that differs, also in the program's version; std::runtime_error if it cannot be written.
void claim_sweep(const std::filesystem::path &folder, const SweepPlan &plan);

} // namespace twiddle::sweeps
