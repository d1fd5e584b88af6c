#include "candidate_log.hpp"

#include "record/csv.hpp"
#include "record/number_text.hpp"
#include "record/part_file.hpp"
#include "record/versions.hpp"

#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

namespace twiddle::calibration
{

namespace
{

std::string name_of(const results::Cell &cell)
{
    return cell.object + "." + cell.model + (cell.centre ? "" : "-no-centre") + "_rad";
}

std::string setting_text(const nlohmann::json &value)
{
    if (value.is_number_float()) return record::number_text(value.get<double>());
    return value.is_string() ? value.get<std::string>() : value.dump();
}

// The columns that tell candidates apart.
std::string key_of(const Candidate &candidate)
{
    std::string key = candidate.stage + "," + std::to_string(candidate.place);
    for (const nlohmann::json &value : candidate.values) {
        key += "," + setting_text(value);
    }
    return key;
}

} // namespace

CandidateLog::CandidateLog(std::filesystem::path path, const calibration::CalibrationPlan &plan,
                           const std::vector<results::Cell> &cells)
    : path_(std::move(path)), columns_({"stage", "point"}), variables_(plan.variables.size()), cells_(cells.size())
{
    comments_ = {
        "candidates of the calibration " + plan.name + ": settings tried, and how far they are from the paper",
        "error_rad: root mean square of ln(ours / paper); error_scaled: the same with ours times scale",
        "cells: trained before the point could no longer be one of the best; with fewer than all, error_rad is "
        "a lower bound",
        "the other columns: mean rotation, rad, of the last 500 trials (last tenth of short runs), over seeds",
        "search seed: " + std::to_string(plan.search.seed) + "; " + record::version_line()};
    for (const calibration::Variable &variable : plan.variables) {
        columns_.push_back(variable.setting);
    }
    columns_.insert(columns_.end(), {"cells", "error_rad", "scale", "error_scaled"});
    for (const results::Cell &cell : cells) {
        columns_.push_back(name_of(cell));
    }
    std::ifstream file(path_);
    bool header = false;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') continue;
        const std::vector<std::string> row = record::split_csv(line);
        if (header ? row.size() != columns_.size() : row != columns_) refuse();
        if (std::exchange(header, true)) read_row(row);
    }
}

void CandidateLog::read_row(const std::vector<std::string> &row)
{
    std::string key = row[0];
    for (std::size_t i = 1; i < 2 + variables_; ++i) {
        key += "," + row[i];
    }
    std::vector<double> &mean_rad = known_[key];
    for (std::size_t i = first_mean(); i < row.size(); ++i) {
        if (row[i].empty()) break; // not trained, nor what follows
        mean_rad.push_back(record::parse_number(row[i]).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
}

std::size_t CandidateLog::first_mean() const
{
    return columns_.size() - cells_;
}

void CandidateLog::refuse() const
{
    throw std::runtime_error("'" + path_.string() + "' is of another calibration; choose another folder by --out");
}

const std::vector<double> *CandidateLog::known(const Candidate &candidate, std::size_t tried) const
{
    const auto found = known_.find(key_of(candidate));
    if (found != known_.end()) return &found->second;
    if (known_.size() > tried) refuse(); // what follows there is not what follows here
    return nullptr;
}

void CandidateLog::write(const std::vector<Candidate> &candidates) const
{
    record::PartFile file(path_);
    for (const std::string &comment : comments_) {
        file.write("# " + comment + "\n");
    }
    file.write(record::csv_header(columns_) + "\n");
    for (const Candidate &candidate : candidates) {
        record::CsvRow row;
        row.cell(std::uint64_t{candidate.mean_rad.size()});
        row.cell(candidate.distance.error_rad).cell(candidate.distance.scale).cell(candidate.distance.error_scaled);
        for (const double mean_rad : candidate.mean_rad) {
            row.cell(mean_rad);
        }
        file.write(key_of(candidate) + "," + row.text());
        file.write(std::string(cells_ - candidate.mean_rad.size(), ',') + "\n");
    }
    file.finish();
}

} // namespace twiddle::calibration
