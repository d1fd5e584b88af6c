#include "run_folder.hpp"

#include "record/part_file.hpp"
#include "usage_error.hpp"

#include <algorithm>

namespace twiddle::runs
{

namespace
{

namespace fs = std::filesystem;

std::optional<record::Run> read_existing(const RunFolder &folder, const std::string &advice)
{
    try {
        return record::read_run(folder.run_json());
    } catch (const std::runtime_error &error) {
        throw UsageError(std::string(error.what()) + "; " + advice);
    }
}

// Whether the folder is empty, but for what a program leaves that is killed while it writes its first file.
bool holds_nothing(const RunFolder &folder)
{
    const fs::path first = record::part_path(folder.run_json());
    return std::all_of(fs::directory_iterator(folder.path), fs::directory_iterator(),
                       [&](const fs::directory_entry &entry) { return entry.path() == first; });
}

} // namespace

fs::path outline_beside(const fs::path &trajectory)
{
    return trajectory.parent_path() / "object_outline.csv";
}

fs::path default_run_path(const record::RunSpecification &specification)
{
    return fs::path("results") / record::folder_of(specification);
}

std::optional<record::Run> claim(const RunFolder &folder, const record::RunSpecification &specification,
                                 const std::string &advice)
{
    const std::string name = "'" + folder.path.string() + "'";
    if (!fs::exists(folder.path)) return std::nullopt;
    if (!fs::is_directory(folder.path)) throw UsageError(name + " is no folder; " + advice);
    if (!fs::exists(folder.run_json())) {
        if (holds_nothing(folder)) return std::nullopt;
        throw UsageError(name + " holds files that are no run of twiddle; " + advice);
    }
    const std::optional<record::Run> run = read_existing(folder, advice);
    if (run->specification != specification)
        throw UsageError(name + " holds another run (" + run->command + "); " + advice);
    return run;
}

void remove_results(const RunFolder &folder)
{
    for (const fs::path &file : {folder.trials_csv(), folder.policy_json(), folder.trajectory_csv(),
                                 outline_beside(folder.trajectory_csv()), folder.replay_html()}) {
        fs::remove(file);
        fs::remove(record::part_path(file));
    }
}

} // namespace twiddle::runs
