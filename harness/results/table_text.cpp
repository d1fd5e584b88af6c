#include "table_text.hpp"

#include "record/number_text.hpp"

#include <iomanip>
#include <locale>
#include <sstream>

namespace twiddle::results
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

} // namespace

Texts joined(Texts first, const Texts &second)
{
    first.insert(first.end(), second.begin(), second.end());
    return first;
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

std::string markdown_table(const Texts &columns, const std::vector<Texts> &rows)
{
    std::string text = markdown_row(columns) + markdown_row(Texts(columns.size(), "---"));
    for (const Texts &row : rows) {
        text += markdown_row(row);
    }
    return text;
}

std::string full(const std::optional<double> &value)
{
    return value ? record::number_text(*value) : "";
}

std::string fixed(double value, int digits)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

} // namespace twiddle::results
