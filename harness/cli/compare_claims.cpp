#include "claims/claims_comparison.hpp"
#include "commands.hpp"
#include "record/json_file.hpp"
#include "runs/usage_error.hpp"

#include <iostream>

namespace twiddle::cli
{

namespace
{

// How the sweep in `folder` is headed: its folder and its set-up.
std::string name_of(const std::filesystem::path &folder)
{
    const std::filesystem::path path = folder / "sweep.json";
    const record::Json sweep = record::read_json(path);
    return folder.string() + ", set-up " + record::json_value<std::string>(sweep, "setup", "a text", path);
}

} // namespace

int run_command(const CompareClaimsOptions &options, const Arguments & /*arguments*/)
{
    std::vector<claims::TestedClaims> sweeps;
    for (const std::filesystem::path folder : options.sweep_dirs) {
        if (!std::filesystem::exists(folder / "sweep.json") || !std::filesystem::exists(folder / "claims.csv"))
            throw runs::UsageError("'" + folder.string() +
                                   "' does not hold sweep.json and claims.csv; run summarize on it first");
        sweeps.push_back({name_of(folder), claims::read_claims_csv(folder / "claims.csv")});
    }
    std::cout << claims::comparison_markdown(sweeps);
    return 0;
}

} // namespace twiddle::cli
