#include "choices.hpp"

#include "engine/engine.hpp"
#include "engine/models.hpp"
#include "link/emulator.hpp"
#include "record/number_text.hpp"
#include "runs/usage_error.hpp"
#include "settings/setup.hpp"
#include "sim/object.hpp"

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace twiddle::cli
{

namespace
{

constexpr std::uint64_t most_jobs = 1024;

// An option with a fixed list of values.
struct Choice {
    std::string option;
    std::vector<std::string> values;
};

const Choice stepper_choice = {"--stepper", {"fast", "reference"}};
const Choice hand_choice = {"--hand", {"welded", "full"}};

bool contains(const std::vector<std::string> &names, const std::string &name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

void require_choice(const Choice &choice, const std::string &value)
{
    if (contains(choice.values, value)) return;
    throw runs::UsageError("unknown value '" + value + "' for " + choice.option + "; expected one of " +
                           comma_list(choice.values));
}

void require_name(const std::string &kind, const std::vector<std::string> &names, const std::string &name)
{
    if (!contains(names, name))
        throw runs::UsageError("unknown " + kind + " '" + name + "'; the " + kind + "s are " + comma_list(names));
}

bool is_toml_path(const std::string &setup)
{
    return std::filesystem::path(setup).extension() == ".toml";
}

settings::Override parse_override(const std::string &text)
{
    const std::size_t equals = text.find('=');
    const std::size_t dot = text.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals)
        throw runs::UsageError("--set " + text + ": expected section.key=value");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

settings::Setup load_setup(const RunOptions &options, const std::filesystem::path &models)
{
    require_setup(models, options.setup);
    std::vector<settings::Override> overrides;
    for (const std::string &text : options.overrides) {
        overrides.push_back(parse_override(text));
    }
    try {
        return settings::load_setup(setups_dir(models), options.setup, overrides);
    } catch (const std::runtime_error &error) {
        throw runs::UsageError(error.what()); // the settings are the user's choice
    }
}

} // namespace

std::filesystem::path models_dir(const std::string &option)
{
    std::filesystem::path path = TWIDDLE_MODELS_DIR;
    const char *environment = std::getenv("TWIDDLE_MODELS");
    if (environment != nullptr && *environment != '\0') path = environment;
    if (!option.empty()) path = option;
    if (!std::filesystem::is_directory(path / "objects"))
        throw runs::UsageError("'" + path.string() + "' is no models folder (with objects/); name one by --models");
    return path;
}

std::filesystem::path experiments_dir(const std::filesystem::path &models)
{
    if (std::filesystem::is_directory(models / "setups")) return models;
    return TWIDDLE_EXPERIMENTS_DIR;
}

std::filesystem::path setups_dir(const std::filesystem::path &models)
{
    return experiments_dir(models) / "setups";
}

std::filesystem::path paper_dir(const std::string &option)
{
    return option.empty() ? TWIDDLE_PAPER_DIR : option;
}

std::vector<std::string> targets()
{
    std::vector<std::string> names = link::emulated_boards();
    names.insert(names.begin(), "host");
    return names;
}

void require_setup(const std::filesystem::path &models, const std::string &setup)
{
    if (!is_toml_path(setup)) require_name("set-up", settings::setup_names(setups_dir(models)), setup);
}

void require_number(const std::string &number)
{
    require_choice({"--number", engine::number_names()}, number);
}

void require_supported(const RunOptions &options)
{
    require_choice(stepper_choice, options.stepper);
    require_choice(hand_choice, options.hand);
    require_number(options.number);
    require_choice({"--target", targets()}, options.target);
}

void require_supported(const record::RunSpecification &specification)
{
    require_choice(stepper_choice, specification.stepper);
    require_choice(hand_choice, specification.hand);
    require_number(specification.number);
}

record::RunSpecification run_specification(const RunOptions &options, const std::filesystem::path &models,
                                           std::uint64_t seed, std::uint32_t trials)
{
    require_name("object", sim::object_names(models), options.object);
    require_name("model", engine::model_names(), options.model);

    record::RunSpecification specification;
    specification.object = options.object;
    specification.model = options.model;
    specification.centre = !options.no_centre;
    specification.seed = seed;
    specification.trials = trials;
    specification.hand = options.hand;
    specification.stepper = options.stepper;
    specification.number = options.number;
    const settings::Setup setup = load_setup(options, models);
    specification.setup = setup.name;
    specification.settings = setup.settings;
    return specification;
}

std::uint64_t whole_number(const std::string &option, const std::string &text, std::uint64_t lower, std::uint64_t upper)
{
    const std::optional<std::uint64_t> value = record::parse_whole_number(text);
    if (!value || *value < lower || *value > upper)
        throw runs::UsageError(option + " " + text + ": expected a whole number from " + std::to_string(lower) +
                               " to " + std::to_string(upper));
    return *value;
}

std::size_t jobs_at_a_time(const std::string &text)
{
    if (text.empty()) return std::max(1U, std::thread::hardware_concurrency());
    return static_cast<std::size_t>(whole_number("--jobs", text, 1, most_jobs));
}

std::string comma_list(const std::vector<std::string> &names)
{
    std::string list;
    for (const std::string &name : names) {
        if (!list.empty()) list += ", ";
        list += name;
    }
    return list;
}

} // namespace twiddle::cli
