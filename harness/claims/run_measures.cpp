#include "run_measures.hpp"

#include "finger_use.hpp"
#include "record/csv_columns.hpp"
#include "record/policy_json.hpp"
#include "record/run_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace twiddle::claims
{

namespace
{

namespace fs = std::filesystem;
using Values = std::vector<double>;

// The weights of CPG-C, -M and -S.
constexpr std::array<const char *, 3> mixture_columns = {"s_c", "s_m", "s_s"};

constexpr double learned_share = 0.8; // of the final rotation, at which a run counts as having learned

double mean_of_last(const Values &values, std::size_t count)
{
    return std::accumulate(values.end() - static_cast<std::ptrdiff_t>(count), values.end(), 0.0) /
           static_cast<double>(count);
}

bool holds_weights(const fs::path &trials_csv)
{
    const std::vector<std::string> names = record::read_csv_header(trials_csv);
    return std::all_of(mixture_columns.begin(), mixture_columns.end(),
                       [&](const char *name) { return std::find(names.begin(), names.end(), name) != names.end(); });
}

void read_trials(const fs::path &path, const results::Sweep &sweep, const std::string &model, RunMeasures &measures)
{
    std::vector<std::string> names = {"rotation_rad"};
    const bool mixes = model == "cpg-h" && holds_weights(path);
    if (mixes) names.insert(names.end(), mixture_columns.begin(), mixture_columns.end());
    const std::vector<Values> columns = record::read_csv_columns(path, names);
    const Values &rotation_rad = columns[0];
    if (rotation_rad.size() != sweep.trials)
        throw std::runtime_error("'" + path.string() + "' has not the run's number of trials");

    measures.final_rotation_rad = mean_of_last(rotation_rad, results::last_trials(sweep));
    measures.mean_rotation_rad = mean_of_last(rotation_rad, rotation_rad.size());
    const bool learned = measures.final_rotation_rad > 0;
    const std::size_t trials =
        learned ? trials_to_reach(rotation_rad, learned_share * measures.final_rotation_rad) : rotation_rad.size();
    measures.log2_trials_to_80 = std::log2(static_cast<double>(trials));
    if (mixes) measures.mixture = mixture_course(columns[1], columns[2], columns[3]);
}

// A number among the settings of a run; nothing if it is not there.
std::optional<double> setting(const nlohmann::json &settings, const char *name)
{
    const auto section = settings.find("oscillators");
    if (section == settings.end() || !section->is_object()) return std::nullopt;
    const auto value = section->find(name);
    if (value == section->end() || !value->is_number()) return std::nullopt;
    return value->get<double>();
}

// The share of the range that the run's policy chose; nothing if it has not learned any.
std::optional<double> learned_frequency(const fs::path &policy_json)
{
    if (!fs::exists(policy_json)) return std::nullopt;
    for (const auto &[name, value] : record::read_policy(policy_json).parameters) {
        if (name == "cpg-c.frequency") return value;
    }
    return std::nullopt;
}

std::optional<Frequency> read_frequency(const fs::path &run_folder, const std::string &model)
{
    const auto settings = nlohmann::json::parse(record::read_run(run_folder / "run.json").specification.settings);
    const std::optional<double> lower_hz = setting(settings, "frequency_lower_hz");
    const std::optional<double> upper_hz = setting(settings, "frequency_upper_hz");
    const std::optional<double> lone_hz = setting(settings, "lone_frequency_hz");
    if (!lower_hz || !upper_hz || !lone_hz || !(*upper_hz > *lower_hz)) return std::nullopt;
    const double range_hz = *upper_hz - *lower_hz;
    if (model == "cpg-m" || model == "cpg-s") return Frequency{*lone_hz, range_hz};
    const std::optional<double> share = learned_frequency(run_folder / "policy.json");
    if (!share) return std::nullopt;
    return Frequency{*lower_hz + *share * range_hz, range_hz};
}

FingerUse read_fingers(const fs::path &trajectory_csv, double frequency_hz)
{
    const std::vector<Values> columns =
        record::read_csv_columns(trajectory_csv, {"time_s", "object_rad", "index_contact_n", "thumb_contact_n",
                                                  "desired_aai_rad", "desired_ot_rad"});
    if (columns[0].empty()) throw std::runtime_error("'" + trajectory_csv.string() + "' has no rows");
    return {lesser_finger_share(columns[1], columns[2], columns[3]),
            phase_distance_turns(columns[0], columns[4], columns[5], frequency_hz)};
}

} // namespace

RunMeasures read_run_measures(const fs::path &folder, const results::Sweep &sweep, const results::SweepRun &run)
{
    const fs::path run_folder = folder / run.folder;
    RunMeasures measures;
    measures.folder = run.folder;
    read_trials(run_folder / "trials.csv", sweep, run.model, measures);
    measures.frequency = read_frequency(run_folder, run.model);
    const fs::path trajectory_csv = run_folder / "trajectory.csv";
    if (run.object == finger_object && measures.frequency && fs::exists(trajectory_csv))
        measures.fingers = read_fingers(trajectory_csv, measures.frequency->value_hz);
    return measures;
}

} // namespace twiddle::claims
