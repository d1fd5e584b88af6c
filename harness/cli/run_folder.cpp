#include "run_folder.hpp"

#include "errors.hpp"
#include "record/part_file.hpp"

namespace twiddle::cli
{

namespace
{

namespace fs = std::filesystem;

std::optional<record::Run> read_existing(const RunFolder &folder)
{
    try {
        return record::read_run(folder.run_json());
    } catch (const std::runtime_error &error) {
        throw UsageError(std::string(error.what()) + "; choose another folder by --out");
    }
}

} // namespace

fs::path outline_beside(const fs::path &trajectory)
{
    return trajectory.parent_path() / "object_outline.csv";
}

fs::path default_run_path(const record::RunSpecification &specification)
{
    const std::string model = specification.model + (specification.centre ? "" : "-no-centre");
    return fs::path("results") / specification.object / model / ("seed-" + std::to_string(specification.seed));
}

std::optional<record::Run> claim(const RunFolder &folder, const record::RunSpecification &specification)
{
    const std::string name = "'" + folder.path.string() + "'";
    if (!fs::exists(folder.path)) return std::nullopt;
    if (!fs::is_directory(folder.path)) throw UsageError(name + " is no folder; choose another by --out");
    if (!fs::exists(folder.run_json())) {
        if (fs::is_empty(folder.path)) return std::nullopt;
        throw UsageError(name + " holds files that are no run of twiddle; choose another folder by --out");
    }
    const std::optional<record::Run> run = read_existing(folder);
    if (run->specification != specification)
        throw UsageError(name + " holds another run (" + run->command + "); choose another folder by --out");
    return run;
}

void remove_results(const RunFolder &folder)
{
    for (const fs::path &file : {folder.trials_csv(), folder.policy_json(), folder.trajectory_csv(),
                                 outline_beside(folder.trajectory_csv())}) {
        fs::remove(file);
        fs::remove(record::part_path(file));
    }
}

} // namespace twiddle::cli
