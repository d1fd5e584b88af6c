#include "csv.hpp"

#include "number_text.hpp"

#include <fstream>
#include <stdexcept>

namespace twiddle::record
{

CsvRow &CsvRow::cell(double value)
{
    return append(number_text(value));
}

CsvRow &CsvRow::cell(double value, std::string_view number)
{
    return append(number_text(value, number));
}

CsvRow &CsvRow::cell(std::uint64_t value)
{
    return append(std::to_string(value));
}

CsvRow &CsvRow::append(const std::string &text)
{
    if (cells_ > 0) text_ += ',';
    text_ += text;
    ++cells_;
    return *this;
}

CsvWriter::CsvWriter(const std::filesystem::path &path, const std::vector<std::string> &comments,
                     const std::vector<std::string> &columns)
    : file_(path), columns_(columns.size())
{
    for (const std::string &text : comments) {
        file_.write("# " + text + "\n");
    }
    file_.write(csv_header(columns) + "\n");
    file_.flush();
}

CsvWriter::CsvWriter(const std::filesystem::path &path, const std::vector<std::string> &columns,
                     std::uintmax_t kept_bytes)
    : file_(path, kept_bytes), columns_(columns.size())
{
}

void CsvWriter::write(const CsvRow &row)
{
    if (row.cells() != columns_) throw std::logic_error("a CSV row must have one value a column");
    file_.write(row.text() + "\n");
    file_.flush(); // a killed program then loses no row
}

void CsvWriter::comment(const std::string &text)
{
    file_.write("# " + text + "\n");
    file_.flush();
}

void CsvWriter::blank_line()
{
    file_.write("\n");
}

void CsvWriter::finish()
{
    file_.finish();
}

CsvPart read_csv_part(const std::filesystem::path &path)
{
    const std::filesystem::path part = part_path(path);
    std::ifstream file(part, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read '" + part.string() + "'");

    CsvPart table;
    std::uintmax_t offset = 0;
    std::string text;
    while (std::getline(file, text) &&
           !file.eof()) { // at the end of the file, the line has no line end: it was cut off
        const bool comment = !text.empty() && text.front() == '#';
        if (!table.header.empty()) {
            table.lines.push_back({text, offset, comment});
        } else if (!comment) {
            table.header = text;
        }
        offset += text.size() + 1;
    }
    return table;
}

std::vector<std::string> split_csv(const std::string &row)
{
    std::vector<std::string> cells;
    std::size_t start = 0;
    for (std::size_t comma = row.find(','); comma != std::string::npos; comma = row.find(',', start)) {
        cells.push_back(row.substr(start, comma - start));
        start = comma + 1;
    }
    cells.push_back(row.substr(start));
    return cells;
}

std::string csv_header(const std::vector<std::string> &columns)
{
    std::string header;
    for (const std::string &column : columns) {
        if (!header.empty()) header += ',';
        header += column;
    }
    return header;
}

} // namespace twiddle::record
