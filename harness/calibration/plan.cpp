#include "plan.hpp"

#include "settings/manifest_file.hpp"

#include <limits>

namespace twiddle::calibration
{

namespace
{

using settings::ManifestFile;
using settings::Names;
using settings::Pointer;

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

// The settings that are not searched.
settings::Setup read_base(const ManifestFile &file, const std::filesystem::path &setups_dir)
{
    const Pointer place("/setup");
    const std::string defaults = (setups_dir / "common.toml").string();
    const settings::Setup base = settings::load_setup(
        setups_dir, file.has(place) ? file.name(place, settings::setup_names(setups_dir), "") : defaults);
    const Pointer own("/settings");
    if (!file.has(own)) return base;
    const std::string expected = "{ \"section.key\" = value }, the names in quotes";
    const nlohmann::json &changes = file.at(own, expected);
    if (!changes.is_object()) file.fail_value(own, expected);
    nlohmann::json merged = nlohmann::json::parse(base.settings);
    for (const auto &[name, value] : changes.items()) {
        if (name.find('.') == std::string::npos) file.fail_value(own, expected);
        settings::put_setting(merged, name, value);
    }
    try {
        return settings::setup_from_settings(merged.dump(), base.name, "settings");
    } catch (const std::runtime_error &error) {
        file.fail(own, error.what());
    }
}

// Refuse a variable that no set-up takes, before any run finds out.
void require_setting(const ManifestFile &file, const Pointer &place, const CalibrationPlan &plan,
                     const Variable &variable)
{
    for (const double corner : {0.0, 1.0}) {
        try {
            const auto values = values_at({variable}, {corner});
            settings::setup_from_settings(with_values(plan.setup.settings, {variable}, values), plan.name,
                                          "at " + values[0].dump());
        } catch (const std::runtime_error &error) {
            file.fail(place, error.what());
        }
    }
}

} // namespace

CalibrationPlan read_calibration_plan(const std::filesystem::path &path, const std::filesystem::path &models_dir,
                                      const std::filesystem::path &setups_dir)
{
    const ManifestFile file(path);
    const Pointer top;
    file.require_keys(top, {"setup", "settings", "seed", "objects", "screening", "finalists", "reach", "variables"});
    CalibrationPlan plan;
    plan.name = path.stem().string();
    plan.setup = read_base(file, setups_dir);
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
