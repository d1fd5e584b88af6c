#include "plan.hpp"

#include "sim/manifest_file.hpp"

#include <limits>

namespace twiddle::calibration
{

namespace
{

using sim::ManifestFile;
using sim::Names;
using sim::Pointer;

constexpr std::int64_t most_points = 1'000'000;
constexpr std::int64_t most_trials = 1'000'000;
constexpr std::int64_t most_seeds = 1'000;

Effort read_effort(const ManifestFile &file, const Pointer &place)
{
    return {static_cast<std::uint32_t>(file.whole_number(place / "trials", most_trials)),
            static_cast<std::uint64_t>(file.whole_number(place / "seeds", most_seeds))};
}

std::size_t count(const ManifestFile &file, const Pointer &place)
{
    return static_cast<std::size_t>(file.whole_number(place, most_points));
}

Variable read_variable(const ManifestFile &file, const Pointer &place)
{
    file.require_keys(place, {"setting", "range", "scale", "values"});
    Variable variable;
    const nlohmann::json &setting = file.at(place / "setting", "\"section.key\"");
    variable.setting = setting.is_string() ? setting.get<std::string>() : "";
    if (variable.setting.find('.') == std::string::npos) file.fail_value(place / "setting", "\"section.key\"");
    if (file.has(place / "values")) {
        const std::string expected = "a list of the setting's values, without range and scale";
        const nlohmann::json &values = file.at(place / "values", expected);
        if (!values.is_array() || values.empty() || file.has(place / "range") || file.has(place / "scale"))
            file.fail_value(place / "values", expected);
        variable.values.assign(values.begin(), values.end());
        return variable;
    }
    std::tie(variable.lower, variable.upper) = file.range(place / "range");
    variable.logarithmic = file.name(place / "scale", {"linear", "logarithmic"}, "linear") == "logarithmic";
    if (variable.logarithmic && variable.lower <= 0) file.fail_value(place / "range", "numbers above 0");
    return variable;
}

// Refuse a variable that no set-up takes, before any run finds out.
void require_setting(const ManifestFile &file, const Pointer &place, const CalibrationPlan &plan,
                     const Variable &variable)
{
    for (const double corner : {0.0, 1.0}) {
        try {
            const auto values = values_at({variable}, {corner});
            sim::setup_from_settings(with_values(plan.setup.settings, {variable}, values), plan.name,
                                     "at " + values[0].dump());
        } catch (const std::runtime_error &error) {
            file.fail(place, error.what());
        }
    }
}

} // namespace

CalibrationPlan read_calibration_plan(const std::filesystem::path &path, const std::filesystem::path &models_dir)
{
    const ManifestFile file(path);
    const Pointer top;
    file.require_keys(top, {"setup", "seed", "objects", "screening", "finalists", "reach", "variables"});
    CalibrationPlan plan;
    plan.name = path.stem().string();
    plan.setup = sim::load_setup(models_dir, file.name(top / "setup", sim::setup_names(models_dir), "mid-a"));
    plan.objects = file.names(top / "objects", sim::object_names(models_dir));

    const Pointer screening = top / "screening";
    const Pointer finalists = top / "finalists";
    const Pointer reach = top / "reach";
    plan.screening = read_effort(file, screening);
    plan.search.seed =
        static_cast<std::uint64_t>(file.whole_number(top / "seed", std::numeric_limits<std::int64_t>::max()));
    plan.search.random = count(file, screening / "random");
    plan.search.refined = count(file, screening / "refined");
    plan.search.parents = count(file, screening / "parents");
    plan.finals = read_effort(file, finalists);
    plan.finalists = count(file, finalists / "count");
    plan.reach.index_fei_deg = file.range(reach / "index_fei_deg");
    plan.reach.index_aai_deg = file.range(reach / "index_aai_deg");
    plan.reach.thumb_fet_deg = file.range(reach / "thumb_fet_deg");
    plan.reach.thumb_ot_deg = file.range(reach / "thumb_ot_deg");
    for (std::size_t i = 0; i < file.blocks(top / "variables"); ++i) {
        const Pointer place = top / "variables" / i;
        plan.variables.push_back(read_variable(file, place));
        require_setting(file, place, plan, plan.variables.back());
    }
    file.require_keys(screening, {"trials", "seeds", "random", "refined", "parents"});
    file.require_keys(finalists, {"count", "trials", "seeds"});
    file.require_keys(reach, {"index_fei_deg", "index_aai_deg", "thumb_fet_deg", "thumb_ot_deg"});
    return plan;
}

} // namespace twiddle::calibration
