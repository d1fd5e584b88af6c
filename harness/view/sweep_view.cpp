#include "sweep_view.hpp"

#include "runs/run_folder.hpp"

#include <algorithm>
#include <stdexcept>

namespace twiddle::view
{

namespace
{

namespace fs = std::filesystem;

// A page is written to each run's folder: none may be elsewhere.
void require_below(const fs::path &run_folder, const fs::path &sweep)
{
    const bool leaves =
        run_folder.is_absolute() || run_folder.empty() ||
        std::any_of(run_folder.begin(), run_folder.end(), [](const fs::path &part) { return part == ".."; });
    if (leaves)
        throw std::runtime_error("'" + (sweep / "sweep.json").string() + "' lists the folder '" + run_folder.string() +
                                 "', which is not below its own");
}

IndexCell index_cell(const results::SweepRun &listed, const fs::path &sweep)
{
    require_below(listed.folder, sweep);
    IndexCell cell;
    cell.run = listed;
    const runs::RunFolder folder{sweep / listed.folder};
    if (!fs::exists(folder.run_json())) return cell;
    const record::Run run = record::read_run(folder.run_json());
    if (run.summary) cell.trained_rad = run.summary->mean_rotation_of_last_rad;
    if (!run.replay) return cell;
    cell.fault = run.replay->fault;
    if (cell.fault.empty()) cell.rotation_rad = run.replay->rotation_rad;
    cell.has_page = cell.fault.empty() && fs::exists(folder.trajectory_csv());
    return cell;
}

} // namespace

SweepView read_sweep_view(const fs::path &folder)
{
    const results::Sweep sweep = results::read_sweep(folder);
    SweepView view;
    view.name = sweep.name;
    view.version = sweep.version;
    for (const results::SweepRun &run : sweep.runs) {
        view.cells.push_back(index_cell(run, folder));
    }
    return view;
}

} // namespace twiddle::view
