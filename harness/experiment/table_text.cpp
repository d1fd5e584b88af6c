#include "table_text.hpp"

#include "record/number_text.hpp"
#include "record/versions.hpp"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

namespace twiddle::experiment
{

namespace
{

std::string csv_line(const Texts &cells)
{
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        line += (i > 0 ? "," : "") + cells[i];
    }
    return line + "\n";
}

std::string markdown_row(const Texts &cells)
{
    std::string row = "|";
    for (const std::string &cell : cells) {
        row += " " + cell + " |";
    }
    return row + "\n";
}

// Which trials count.
std::string last_trials_text(const Sweep &sweep)
{
    const std::string trials = std::to_string(sweep.trials);
    if (sweep.trials < most_last_trials)
        return "over all " + trials + " trials, since the runs have fewer than " + std::to_string(most_last_trials);
    return "over the last " + std::to_string(last_trials(sweep)) + " of " + trials + " trials";
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

std::string full(const std::optional<double> &value)
{
    return value ? record::number_text(*value) : "";
}

std::string truth(bool value)
{
    return value ? "true" : "false";
}

std::string fixed(double value, int digits)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

std::string markdown_table(const Texts &columns, const std::vector<Texts> &rows)
{
    if (rows.empty()) return "The sweep has no runs of this table.\n";
    std::string text = markdown_row(columns) + markdown_row(Texts(columns.size(), "---"));
    for (const Texts &row : rows) {
        text += markdown_row(row);
    }
    return text;
}

std::string model_text(const std::string &model, bool centre)
{
    std::string name = model;
    std::transform(name.begin(), name.end(), name.begin(), [](char letter) {
        return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 32) : letter;
    });
    return name + (centre ? "" : " without centre");
}

} // namespace twiddle::experiment
