#include "results_text.hpp"

#include "record/number_text.hpp"
#include "record/versions.hpp"

namespace twiddle::experiment
{

namespace
{

// Which trials count.
std::string last_trials_text(const Sweep &sweep)
{
    const std::string trials = std::to_string(sweep.trials);
    if (sweep.trials < most_last_trials)
        return "over all " + trials + " trials, since the runs have fewer than " + std::to_string(most_last_trials);
    return "over the last " + std::to_string(last_trials(sweep)) + " of " + trials + " trials";
}

std::string csv_line(const Texts &cells)
{
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        line += (i > 0 ? "," : "") + cells[i];
    }
    return line + "\n";
}

} // namespace

std::string rotation_text(const Sweep &sweep)
{
    return "a run counts with its mean rotation in rad " + last_trials_text(sweep);
}

std::string origin_text(const Sweep &sweep)
{
    return "sweep " + sweep.name + " of " + sweep.version + ", summarized by " + record::version_line();
}

Texts joined(Texts first, const Texts &second)
{
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::string number_cell(const std::optional<double> &value)
{
    return value ? record::number_text(*value) : "";
}

std::string truth_cell(bool value)
{
    return value ? "true" : "false";
}

std::string csv_text(const Texts &comments, const Texts &columns, const std::vector<Texts> &rows)
{
    std::string text;
    for (const std::string &comment : comments) {
        text += "# " + comment + "\n";
    }
    text += csv_line(columns);
    for (const Texts &row : rows) {
        text += csv_line(row);
    }
    return text;
}

} // namespace twiddle::experiment
