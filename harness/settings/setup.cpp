#include "setup.hpp"

#include "setting_table.hpp"
#include "toml_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace twiddle::settings
{
namespace
{

using nlohmann::json;

[[noreturn]] void fail(const std::string &source, const std::string &what)
{
    throw std::runtime_error(source + ": " + what);
}

std::string title(const std::string &section, const std::string &key)
{
    return "[" + section + "] " + key;
}

// `value` as it would stand in a file, for an error.
std::string quoted(const json &value)
{
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (!(number - number == 0)) return number != number ? "nan" : number > 0 ? "inf" : "-inf";
    }
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

// What may stand in `section`; all sections if it is empty.
std::string known_names(const std::string &section)
{
    std::vector<std::string> names;
    for (const auto &setting : setting_table()) {
        if (!section.empty() && setting.section != section) continue;
        const std::string &name = section.empty() ? setting.section : setting.key;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::string list;
    for (const auto &name : names)
        list += (list.empty() ? "" : ", ") + name;
    return list;
}

const Setting &find_setting(const std::string &section, const std::string &key, const std::string &source)
{
    bool section_known = false;
    for (const auto &setting : setting_table()) {
        if (setting.section != section) continue;
        if (setting.key == key) return setting;
        section_known = true;
    }
    if (!section_known) fail(source, "there is no section [" + section + "]; expected one of " + known_names(""));
    fail(source, "there is no setting " + title(section, key) + "; expected one of " + known_names(section));
}

void store_value(const Setting &setting, const json &value, const std::string &source, Setup &setup)
{
    if (setting.store(value, setup)) return;
    fail(source, title(setting.section, setting.key) + " is " + quoted(value) + "; expected " + setting.expected);
}

// Check every value of `layer`, which comes from `source`, and put it over `settings`.
void merge(const json &layer, const std::string &source, json &settings)
{
    if (!layer.is_object()) fail(source, "these are no settings; expected sections of named values");
    Setup scratch;
    for (const auto &[section, values] : layer.items()) {
        if (!values.is_object())
            fail(source, "\"" + section + "\" is no section; expected [section] and settings below it");
        if (values.empty() && known_names(section).empty()) find_setting(section, "", source);
        for (const auto &[key, value] : values.items()) {
            store_value(find_setting(section, key, source), value, source, scratch);
            settings[section][key] = value;
        }
    }
}

json parse_override(const Override &override_)
{
    const auto &[name, text] = override_;
    const auto dot = name.find('.');
    if (dot == std::string::npos) fail("--set", "\"" + name + "\" is no setting; expected section.key=value");
    const std::string section = name.substr(0, dot);
    const std::string key = name.substr(dot + 1);
    const Setting &setting = find_setting(section, key, "--set");
    try {
        return {{section, {{key, toml_value(text)}}}};
    } catch (const std::runtime_error &error) {
        fail("--set", title(section, key) + ": " + error.what() + "; expected " + setting.expected);
    }
}

// What must hold between settings.
void check_together(const Setup &setup, const std::string &source)
{
    const auto &oscillators = setup.oscillators;
    if (!(oscillators.frequency_lower_hz < oscillators.frequency_upper_hz)) {
        fail(source, "[oscillators] frequency_lower_hz must be below frequency_upper_hz");
    }
    if (!(oscillators.centre_lower < oscillators.centre_upper)) {
        fail(source, "[oscillators] centre_lower must be below centre_upper");
    }
    if (setup.learner.noise_end > setup.learner.noise_start) {
        fail(source, "[learner] noise_end must not be above noise_start");
    }
}

// The file that `name` means: a path that ends in .toml, or a name in `setups_dir`.
std::filesystem::path setup_path(const std::filesystem::path &setups_dir, const std::string &name)
{
    if (std::filesystem::path(name).extension() == ".toml") return name;
    const auto known = setup_names(setups_dir);
    if (std::find(known.begin(), known.end(), name) != known.end()) return setups_dir / (name + ".toml");
    std::string list;
    for (const auto &each : known)
        list += (list.empty() ? "" : ", ") + each;
    throw std::runtime_error("there is no set-up \"" + name + "\" in " + setups_dir.string() +
                             "; known set-ups: " + list);
}

Setup read_setup(const json &settings, const std::string &name, const std::string &source)
{
    json merged = json::object();
    merge(settings, source, merged);
    Setup setup;
    setup.name = name;
    for (const auto &setting : setting_table()) {
        const auto section = merged.find(setting.section);
        if (section == merged.end() || !section->contains(setting.key)) {
            fail(source, title(setting.section, setting.key) + " is missing; expected " + setting.expected);
        }
        store_value(setting, (*section)[setting.key], source, setup);
    }
    check_together(setup, source);
    setup.settings = merged.dump();
    return setup;
}

} // namespace

Setup load_setup(const std::filesystem::path &setups_dir, const std::string &name,
                 const std::vector<Override> &overrides)
{
    const auto path = setup_path(setups_dir, name);
    const auto common = setups_dir / "common.toml";
    json settings = json::object();
    merge(read_toml(common), common.string(), settings);
    read_setup(settings, name, common.string()); // common.toml must be complete
    merge(read_toml(path), path.string(), settings);
    for (const auto &each : overrides)
        merge(parse_override(each), "--set", settings);
    return read_setup(settings, path.stem().string(), path.string() + (overrides.empty() ? "" : " with --set"));
}

Setup setup_from_settings(const std::string &settings, const std::string &name, const std::string &source)
{
    return read_setup(json::parse(settings, nullptr, false), name, source);
}

std::vector<std::string> setup_names(const std::filesystem::path &setups_dir)
{
    if (!std::filesystem::is_directory(setups_dir))
        throw std::runtime_error(setups_dir.string() + ": there is no such folder of set-ups");
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(setups_dir)) {
        if (entry.path().extension() == ".toml" && entry.path().stem() != "common")
            names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace twiddle::settings
