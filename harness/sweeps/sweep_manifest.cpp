#include "sweep_manifest.hpp"

#include "engine/models.hpp"
#include "experiment/training.hpp"
#include "record/json_file.hpp"
#include "record/versions.hpp"
#include "settings/manifest_file.hpp"
#include "settings/setup.hpp"
#include "sim/object.hpp"
#include "sim/world.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace twiddle::sweeps
{

namespace
{

using nlohmann::json;
using settings::contains;
using settings::ManifestFile;
using settings::Names;
using settings::Pointer;

constexpr std::int64_t most_seeds = 100'000;

const Names manifest_keys = {"trials", "setup", "stepper", "runs"};
const Names block_keys = {"objects", "models", "centre", "seeds", "variant", "set"};

// Makes the plan of one manifest.
class Planner
{
  public:
    Planner(const std::filesystem::path &path, const SweepFolders &folders, const record::RunSpecification &defaults,
            const std::string &setup)
        : manifest_(path), objects_(sim::object_names(folders.models)), models_(engine::model_names())
    {
        manifest_.require_keys(Pointer(), manifest_keys);
        plan_.name = path.stem().string();
        plan_.common = defaults;
        plan_.common.trials = static_cast<std::uint32_t>(
            manifest_.whole_number(Pointer("/trials"), std::int64_t{experiment::most_trials}));
        plan_.common.stepper = manifest_.name(Pointer("/stepper"), sim::stepper_names(), defaults.stepper);
        const std::string own = own_setup(path.parent_path(), defaults.setup);
        if (!setup.empty()) {
            take(settings::load_setup(folders.setups, setup));
            return;
        }
        try {
            take(settings::load_setup(folders.setups, own));
        } catch (const std::runtime_error &error) {
            manifest_.fail(Pointer("/setup"), std::string("setup: ") + error.what());
        }
    }

    SweepPlan plan() &&
    {
        const Pointer place("/runs");
        const std::size_t blocks = manifest_.blocks(place);
        for (std::size_t i = 0; i < blocks; ++i) {
            add_block(place / i);
        }
        return std::move(plan_);
    }

  private:
    // The set-up that the manifest in `folder` names, as load_setup() takes it; `silent` where it names none.
    std::string own_setup(const std::filesystem::path &folder, const std::string &silent) const
    {
        const Pointer place("/setup");
        if (!manifest_.has(place)) return silent;
        const json &value = manifest_.at(place, "");
        if (!value.is_string()) manifest_.fail_value(place, "the name of a set-up");
        const std::string name = value.get<std::string>();
        return std::filesystem::path(name).extension() == ".toml" ? (folder / name).string() : name;
    }

    void take(const settings::Setup &setup)
    {
        plan_.common.setup = setup.name;
        plan_.common.settings = setup.settings;
    }

    // The name of the block's variant, which becomes a folder; empty if it has none.
    std::string variant(const Pointer &block) const
    {
        const Pointer place = block / "variant";
        if (!manifest_.has(place)) return "";
        const json &value = manifest_.at(place, "");
        const std::string name = value.is_string() ? value.get<std::string>() : "";
        const auto is_part = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
        };
        if (name.empty() || name[0] == '.' || name[0] == '-' || !std::all_of(name.begin(), name.end(), is_part))
            manifest_.fail_value(place, "a name of a-z, 0-9, . and - that starts with a letter or digit");
        if (contains(objects_, name)) manifest_.fail_value(place, "another name than an object's");
        return name;
    }

    // The settings in which the block differs, as {"section.key": value}.
    record::Json overrides(const Pointer &block) const
    {
        const Pointer place = block / "set";
        record::Json found = record::Json::object();
        if (!manifest_.has(place)) return found;
        const std::string expected = "{ \"section.key\" = value }, the names in quotes";
        const json &table = manifest_.at(place, expected);
        if (!table.is_object()) manifest_.fail_value(place, expected);
        for (const auto &[name, value] : table.items()) {
            if (name.find('.') == std::string::npos)
                manifest_.fail(place, "set: \"" + name + "\" is no setting; expected " + expected);
            found[name] = value;
        }
        return found;
    }

    // The settings of variant `name`, with the overrides that its first block names.
    std::string settings_of(const Pointer &block, const std::string &name)
    {
        const record::Json changes = overrides(block);
        if (name.empty() && !changes.empty())
            manifest_.fail(block / "set",
                           "set without a variant; expected variant = \"NAME\" for the folder of these runs");
        const auto [known, is_new] = plan_.overrides.emplace(name, changes.dump());
        if (!is_new && record::Json::parse(known->second) != changes)
            manifest_.fail(block / "variant",
                           "variant \"" + name + "\" has another set than before; expected the same");
        json merged = json::parse(plan_.common.settings);
        for (const auto &[setting, value] : changes.items()) {
            settings::put_setting(merged, setting, value);
        }
        try {
            return settings::setup_from_settings(merged.dump(), plan_.common.setup, "set").settings;
        } catch (const std::runtime_error &error) {
            manifest_.fail(block / "set", error.what());
        }
    }

    void add_block(const Pointer &block)
    {
        manifest_.require_keys(block, block_keys);
        PlannedRun run;
        run.variant = variant(block);
        run.specification = plan_.common;
        run.specification.settings = settings_of(block, run.variant);
        const std::vector<bool> centres = manifest_.flags(block / "centre");
        const auto seeds = static_cast<std::uint64_t>(manifest_.whole_number(block / "seeds", most_seeds));
        const Names models = manifest_.names(block / "models", models_);
        for (const std::string &object : manifest_.names(block / "objects", objects_)) {
            for (const std::string &model : models) {
                for (const bool centre : centres) {
                    run.specification.object = object;
                    run.specification.model = model;
                    run.specification.centre = centre;
                    add_seeds(block, run, seeds);
                }
            }
        }
    }

    void add_seeds(const Pointer &block, PlannedRun run, std::uint64_t seeds)
    {
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            run.specification.seed = seed;
            const std::filesystem::path variant = run.variant;
            run.folder = (variant / record::folder_of(run.specification)).string();
            if (!folders_.insert(run.folder).second)
                manifest_.fail(block, "run " + run.folder + " is listed twice; expected every run once");
            plan_.runs.push_back(run);
        }
    }

    ManifestFile manifest_;
    Names objects_;
    Names models_;
    SweepPlan plan_;
    std::set<std::string> folders_;
};

} // namespace

SweepPlan read_sweep_manifest(const std::filesystem::path &path, const SweepFolders &folders,
                              const record::RunSpecification &defaults, const std::string &setup)
{
    return Planner(path, folders, defaults, setup).plan();
}

record::Json sweep_json(const SweepPlan &plan)
{
    record::Json file;
    file["format"] = 1;
    file["sweep"] = plan.name;
    file["version"] = record::version_line();
    file["trials"] = plan.common.trials;
    file["hand"] = plan.common.hand;
    file["stepper"] = plan.common.stepper;
    file["number"] = plan.common.number;
    file["setup"] = plan.common.setup;
    file["settings"] = json::parse(plan.common.settings);
    file["variants"] = record::Json::object();
    for (const auto &[variant, changes] : plan.overrides) {
        if (!variant.empty()) file["variants"][variant] = record::Json::parse(changes);
    }
    file["runs"] = record::Json::array();
    for (std::size_t index = 0; index < plan.runs.size(); ++index) {
        const PlannedRun &run = plan.runs[index];
        const record::RunSpecification &specification = run.specification;
        file["runs"].push_back({{"index", index},
                                {"folder", run.folder},
                                {"object", specification.object},
                                {"model", specification.model},
                                {"centre", specification.centre},
                                {"seed", specification.seed},
                                {"variant", run.variant}});
    }
    return file;
}

} // namespace twiddle::sweeps
