#include "trial_log.hpp"

#include "record/number_text.hpp"
#include "record/part_file.hpp"
#include "record/versions.hpp"

#include <stdexcept>

namespace twiddle::runs
{

namespace
{

const std::string fault_mark = "fault: ";

// The rotation is the world's; the rest are numbers of the library.
record::CsvRow csv_row(const experiment::TrialRow &row, const std::string &number)
{
    record::CsvRow csv;
    csv.cell(std::uint64_t{row.trial}).cell(row.rotation_rad);
    for (const double value : {row.reward, row.value, row.td_error, row.noise}) {
        csv.cell(value, number);
    }
    for (const double weight : row.weight) {
        csv.cell(weight, number);
    }
    return csv;
}

double rotation_of(const std::string &text, const std::filesystem::path &path)
{
    const std::vector<std::string> cells = record::split_csv(text);
    const std::optional<double> rotation_rad =
        cells.size() == trial_log_columns().size() ? record::parse_number(cells[1]) : std::nullopt;
    if (!rotation_rad)
        throw std::runtime_error("'" + record::part_path(path).string() + "' has a row that is no trial: " + text);
    return *rotation_rad;
}

} // namespace

std::vector<std::string> trial_log_comments(const record::RunSpecification &specification)
{
    return {"one row a trial of a training run; all settings are in run.json",
            "object: " + specification.object + ", model: " + specification.model +
                (specification.centre ? ", with centre" : ", without centre"),
            "rotation_rad: of the object in 3 s, in the set-up's counted direction; value: the critic's estimate of "
            "the reward",
            "noise: half-range of the exploration noise in force; s_c, s_m, s_s: the weights of CPG-C, -M and -S",
            "seed: " + std::to_string(specification.seed),
            record::version_line() + ", number type " + specification.number};
}

const std::vector<std::string> &trial_log_columns()
{
    static const std::vector<std::string> columns = {"trial", "rotation_rad", "reward", "value", "td_error",
                                                     "noise", "s_c",          "s_m",    "s_s"};
    return columns;
}

void write_trial(record::CsvWriter &writer, const experiment::TrialRow &row, const std::string &number)
{
    writer.write(csv_row(row, number));
    if (!row.fault.empty()) writer.comment(fault_mark + row.fault);
}

std::string trial_text(const experiment::TrialRow &row, const std::string &number)
{
    return csv_row(row, number).text();
}

std::vector<RecordedTrial> read_recorded_trials(const std::filesystem::path &path)
{
    std::vector<RecordedTrial> trials;
    if (!std::filesystem::exists(record::part_path(path))) return trials;
    const record::CsvPart part = record::read_csv_part(path);
    if (!part.header.empty() && part.header != record::csv_header(trial_log_columns()))
        throw std::runtime_error("'" + record::part_path(path).string() + "' is no log of trials");
    for (const record::CsvLine &line : part.lines) {
        if (!line.comment) {
            trials.push_back({rotation_of(line.text, path), line.text, line.offset, false});
        } else if (!trials.empty()) {
            trials.back().fault = true;
        }
    }
    return trials;
}

} // namespace twiddle::runs
