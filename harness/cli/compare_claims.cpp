#include "commands.hpp"
#include "errors.hpp"
#include "record/json_file.hpp"
#include "results/claims_comparison.hpp"

#include <iostream>
#include <memory>

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

int compare_claims(const std::vector<std::string> &folders)
{
    std::vector<results::TestedClaims> sweeps;
    for (const std::filesystem::path folder : folders) {
        if (!std::filesystem::exists(folder / "sweep.json") || !std::filesystem::exists(folder / "claims.csv"))
            throw UsageError("'" + folder.string() +
                             "' does not hold sweep.json and claims.csv; run summarize on it first");
        sweeps.push_back({name_of(folder), results::read_claims_csv(folder / "claims.csv")});
    }
    std::cout << results::comparison_markdown(sweeps);
    return 0;
}

} // namespace

void add_compare_claims(CLI::App &app, Session &session)
{
    CLI::App *command = app.add_subcommand(
        "compare-claims", "Put the claims of several summarized sweeps side by side, as Markdown on standard output");
    const auto folders = std::make_shared<std::vector<std::string>>();
    command->add_option("DIR", *folders, "Folders of sweeps, with claims.csv")->required()->type_name("");
    command->callback([folders, &session] { session.run = [folders] { return compare_claims(*folders); }; });
}

} // namespace twiddle::cli
