#include "options.hpp"

#include "errors.hpp"
#include "executable.hpp"
#include "experiment/models.hpp"
#include "record/number_text.hpp"
#include "sim/object.hpp"
#include "sim/setup.hpp"
#include "target.hpp"

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
const Choice number_choice = {"--number", {"float", "double", "fixed"}};

bool contains(const std::vector<std::string> &names, const std::string &name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

void require_choice(const Choice &choice, const std::string &value)
{
    if (contains(choice.values, value)) return;
    throw UsageError("unknown value '" + value + "' for " + choice.option + "; expected one of " +
                     comma_list(choice.values));
}

void require_name(const std::string &kind, const std::vector<std::string> &names, const std::string &name)
{
    if (!contains(names, name))
        throw UsageError("unknown " + kind + " '" + name + "'; the " + kind + "s are " + comma_list(names));
}

bool is_toml_path(const std::string &setup)
{
    return std::filesystem::path(setup).extension() == ".toml";
}

sim::Override parse_override(const std::string &text)
{
    const std::size_t equals = text.find('=');
    const std::size_t dot = text.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals)
        throw UsageError("--set " + text + ": expected section.key=value");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

sim::Setup load_setup(const RunOptions &options, const std::filesystem::path &models)
{
    require_setup(models, options.setup);
    std::vector<sim::Override> overrides;
    for (const std::string &text : options.overrides) {
        overrides.push_back(parse_override(text));
    }
    try {
        return sim::load_setup(models, options.setup, overrides);
    } catch (const std::runtime_error &error) {
        throw UsageError(error.what()); // the settings are the user's choice
    }
}

} // namespace

void add_models_option(CLI::App &command, std::string &models_dir)
{
    command.add_option("--models", models_dir, "Folder of hand, objects and set-ups")->type_name("DIR");
}

void add_run_options(CLI::App &command, RunOptions &options)
{
    options.number = own_number();
    command.add_option("--object", options.object, "{small,medium,large}-{sphere,cylinder,cube}")
        ->required()
        ->type_name("NAME");
    command.add_option("--model", options.model, "cpg-s, cpg-m, cpg-c or cpg-h")->required()->type_name("NAME");
    command.add_flag("--no-centre", options.no_centre, "Oscillators without a centre parameter");
    command.add_option("--setup", options.setup, "Physical and learning set-up, or a .toml file")
        ->type_name("NAME")
        ->capture_default_str();
    command.add_option("--set", options.overrides, "Override one setting; may be repeated")
        ->type_name("section.key=value")
        ->allow_extra_args(false);
    command.add_option("--stepper", options.stepper, "Physics")->type_name("NAME")->capture_default_str();
    command.add_option("--hand", options.hand, "welded, or full: all 19 joints movable")
        ->type_name("NAME")
        ->capture_default_str();
    command.add_option("--number", options.number, "Number type of the C library: float, double or fixed")
        ->type_name("TYPE")
        ->capture_default_str()
        ->each([&options](const std::string &) { options.number_given = true; });
    command.add_option("--target", options.target, "Where the C library runs: " + comma_list(targets()))
        ->type_name("NAME")
        ->capture_default_str();
    add_models_option(command, options.models_dir);
}

std::filesystem::path models_dir(const std::string &option)
{
    std::filesystem::path path = TWIDDLE_MODELS_DIR;
    const char *environment = std::getenv("TWIDDLE_MODELS");
    if (environment != nullptr && *environment != '\0') path = environment;
    if (!option.empty()) path = option;
    if (!std::filesystem::is_directory(path / "objects") || !std::filesystem::is_directory(path / "setups"))
        throw UsageError("'" + path.string() +
                         "' is no models folder (with objects/ and setups/); name one by --models");
    return path;
}

void require_setup(const std::filesystem::path &models, const std::string &setup)
{
    if (!is_toml_path(setup)) require_name("set-up", sim::setup_names(models), setup);
}

void require_supported(const RunOptions &options)
{
    require_choice(stepper_choice, options.stepper);
    require_choice(hand_choice, options.hand);
    require_choice(number_choice, options.number);
    require_choice({"--target", targets()}, options.target);
}

void require_supported(const record::RunSpecification &specification)
{
    require_choice(stepper_choice, specification.stepper);
    require_choice(hand_choice, specification.hand);
    require_choice(number_choice, specification.number);
}

record::RunSpecification run_specification(const RunOptions &options, const std::filesystem::path &models,
                                           std::uint64_t seed, std::uint32_t trials)
{
    require_name("object", sim::object_names(models), options.object);
    require_name("model", experiment::model_names(), options.model);

    record::RunSpecification specification;
    specification.object = options.object;
    specification.model = options.model;
    specification.centre = !options.no_centre;
    specification.seed = seed;
    specification.trials = trials;
    specification.hand = options.hand;
    specification.stepper = options.stepper;
    specification.number = options.number;
    const sim::Setup setup = load_setup(options, models);
    specification.setup = setup.name;
    specification.settings = setup.settings;
    return specification;
}

std::uint64_t whole_number(const std::string &option, const std::string &text, std::uint64_t lower, std::uint64_t upper)
{
    const std::optional<std::uint64_t> value = record::parse_whole_number(text);
    if (!value || *value < lower || *value > upper)
        throw UsageError(option + " " + text + ": expected a whole number from " + std::to_string(lower) + " to " +
                         std::to_string(upper));
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
