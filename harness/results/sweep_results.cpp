#include "sweep_results.hpp"

#include "record/json_file.hpp"
#include "record/run_json.hpp"
#include "rotation_log.hpp"
#include "statistics.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace twiddle::results
{

namespace
{

namespace fs = std::filesystem;

constexpr std::uint64_t sweep_format = 1;
constexpr std::size_t most_named = 5; // of the runs that are not complete

auto cell_key(const SweepRun &run)
{
    return std::tie(run.variant, run.object, run.model, run.centre);
}

auto cell_key(const Cell &cell)
{
    return std::tie(cell.variant, cell.object, cell.model, cell.centre);
}

SweepRun read_listed_run(const record::Json &json, const fs::path &path)
{
    if (!json.is_object()) throw std::runtime_error("'" + path.string() + "': 'runs' must list objects");
    const auto text = [&](const char *key) { return record::json_value<std::string>(json, key, "a text", path); };
    SweepRun run;
    run.folder = text("folder");
    run.variant = text("variant");
    run.object = text("object");
    run.model = text("model");
    run.centre = record::json_value<bool>(json, "centre", "true or false", path);
    run.seed = record::json_value<std::uint64_t>(json, "seed", "a whole number", path);
    return run;
}

// The settings in which a variant differs, as a reader would write them.
std::string changes_text(const record::Json &changes)
{
    std::string text;
    for (const auto &[setting, value] : changes.items()) {
        text += (text.empty() ? "" : ", ") + setting + " = " + value.dump();
    }
    return text;
}

void require_distinct(const std::vector<SweepRun> &runs, const fs::path &path)
{
    std::set<std::tuple<std::string, std::string, std::string, bool, std::uint64_t>> known;
    for (const SweepRun &run : runs) {
        if (!known.insert({run.variant, run.object, run.model, run.centre, run.seed}).second)
            throw std::runtime_error("'" + path.string() + "' lists the run of '" + run.folder + "' twice");
    }
}

// A run whose folder was read.
struct FinishedRun {
    const SweepRun *listed = nullptr;
    record::RunSpecification specification;
};

bool is_complete(const fs::path &folder, record::RunSpecification &specification)
{
    if (!fs::exists(folder / "run.json")) return false;
    record::Run run = record::read_run(folder / "run.json");
    specification = std::move(run.specification);
    return run.complete && fs::is_regular_file(folder / "trials.csv");
}

std::string sentence_of_missing(const std::vector<std::string> &missing, std::size_t runs)
{
    std::string sentence = std::to_string(missing.size()) + " of " + std::to_string(runs) +
                           " runs of the sweep are missing or not complete: ";
    for (std::size_t i = 0; i < std::min(most_named, missing.size()); ++i) {
        sentence += (i > 0 ? ", " : "") + missing[i];
    }
    return sentence + (missing.size() > most_named ? ", ..." : "") + "; finish the sweep first";
}

std::vector<FinishedRun> finished_runs(const fs::path &folder, const Sweep &sweep)
{
    std::vector<FinishedRun> finished(sweep.runs.size());
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
        finished[i].listed = &sweep.runs[i];
        if (!is_complete(folder / sweep.runs[i].folder, finished[i].specification))
            missing.push_back(sweep.runs[i].folder);
    }
    if (!missing.empty()) throw std::runtime_error(sentence_of_missing(missing, sweep.runs.size()));
    return finished;
}

void require_listed(const FinishedRun &run, const Sweep &sweep, const fs::path &run_json)
{
    const record::RunSpecification &found = run.specification;
    const SweepRun &listed = *run.listed;
    if (std::tie(found.object, found.model, found.centre, found.seed, found.trials) !=
        std::tie(listed.object, listed.model, listed.centre, listed.seed, sweep.trials))
        throw std::runtime_error("'" + run_json.string() + "' is of another run than sweep.json lists for its folder");
}

// Runs of one cell may differ in the seed alone.
void require_same_settings(record::RunSpecification run, const record::RunSpecification &first,
                           const fs::path &run_json)
{
    run.seed = first.seed;
    if (run != first)
        throw std::runtime_error("'" + run_json.string() +
                                 "' has other settings than the first run of its model and object");
}

double mean_of_last(const std::vector<double> &values, std::uint32_t last)
{
    return mean({values.end() - static_cast<std::ptrdiff_t>(last), values.end()});
}

} // namespace

std::uint32_t last_trials(const Sweep &sweep)
{
    return std::min(most_last_trials, sweep.trials);
}

Sweep read_sweep(const fs::path &folder)
{
    const fs::path path = folder / "sweep.json";
    const record::Json json = record::read_json(path);
    if (record::json_value<std::uint64_t>(json, "format", "1", path) != sweep_format)
        throw std::runtime_error("'" + path.string() + "': 'format' must be 1");
    Sweep sweep;
    sweep.name = record::json_value<std::string>(json, "sweep", "a text", path);
    sweep.version = record::json_value<std::string>(json, "version", "a text", path);
    sweep.trials = record::json_value<std::uint32_t>(json, "trials", "a whole number", path);
    if (sweep.trials == 0) throw std::runtime_error("'" + path.string() + "': 'trials' must be at least 1");
    if (json.contains("variants")) {
        const auto variants = record::json_value<record::Json>(json, "variants", "an object of variants", path);
        for (const auto &[variant, changes] : variants.items()) {
            sweep.changes[variant] = changes_text(changes);
        }
    }
    const auto runs = json.find("runs");
    if (runs == json.end() || !runs->is_array() || runs->empty())
        throw std::runtime_error("'" + path.string() + "': 'runs' must be a list of runs");
    for (const record::Json &run : *runs) {
        sweep.runs.push_back(read_listed_run(run, path));
    }
    require_distinct(sweep.runs, path);
    return sweep;
}

std::vector<Cell> read_cells(const fs::path &folder, const Sweep &sweep)
{
    std::vector<Cell> cells;
    std::vector<record::RunSpecification> first_of_cell;
    for (const FinishedRun &run : finished_runs(folder, sweep)) {
        const SweepRun &listed = *run.listed;
        const fs::path run_folder = folder / listed.folder;
        require_listed(run, sweep, run_folder / "run.json");
        auto cell = std::find_if(cells.begin(), cells.end(),
                                 [&](const Cell &known) { return cell_key(known) == cell_key(listed); });
        if (cell == cells.end()) {
            cell = cells.insert(cells.end(), {listed.variant, listed.object, listed.model, listed.centre, {}, {}});
            first_of_cell.push_back(run.specification);
        }
        require_same_settings(run.specification, first_of_cell[static_cast<std::size_t>(cell - cells.begin())],
                              run_folder / "run.json");
        std::vector<double> rotation_rad = read_rotations(run_folder / "trials.csv", sweep.trials);
        cell->rotation_rad.push_back(mean_of_last(rotation_rad, last_trials(sweep)));
        cell->runs.push_back({listed.folder, listed.seed, std::move(rotation_rad)});
    }
    return cells;
}

} // namespace twiddle::results
