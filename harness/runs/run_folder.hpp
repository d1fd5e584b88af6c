// run_folder.hpp: the folder of one training run, and what may be done to a folder that is already there.
#pragma once

#include "record/run_json.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace twiddle::runs
{

// The files of a run.
struct RunFolder {
    std::filesystem::path path;

    std::filesystem::path run_json() const
    {
        return path / "run.json";
    }
    std::filesystem::path trials_csv() const
    {
        return path / "trials.csv";
    }
    std::filesystem::path policy_json() const
    {
        return path / "policy.json";
    }
    std::filesystem::path trajectory_csv() const
    {
        return path / "trajectory.csv";
    }
    std::filesystem::path replay_html() const
    {
        return path / "replay.html";
    }
};

// The outline that goes with the trajectory file `trajectory`.
std::filesystem::path outline_beside(const std::filesystem::path &trajectory);

// results/OBJECT/MODEL[-no-centre]/seed-N
std::filesystem::path default_run_path(const record::RunSpecification &specification);

// The run in the folder, if there is one of `specification`; nothing if the folder is missing or empty. Throws
// UsageError if the folder holds anything else, with `advice` as the sentence's end; it is then to stay as it is.
std::optional<record::Run> claim(const RunFolder &folder, const record::RunSpecification &specification,
                                 const std::string &advice);

// Remove what an earlier run of the same specification left beside run.json.
void remove_results(const RunFolder &folder);

} // namespace twiddle::runs
