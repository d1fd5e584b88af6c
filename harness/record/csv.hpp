// csv.hpp: tables as CSV: `#` lines that say what, units, seed and version, one header row, rows of numbers.
//
// gnuplot and pandas (comment='#') read the files as they are. Numbers keep their full precision.
#pragma once

#include "part_file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace twiddle::record
{

// The values of one row.
class CsvRow
{
  public:
    CsvRow &cell(double value);
    // A value that the C library holds in its number type `number` (number_text.hpp).
    CsvRow &cell(double value, std::string_view number);
    CsvRow &cell(std::uint64_t value);

    // The row as it stands in the file, without the line end.
    const std::string &text() const
    {
        return text_;
    }
    std::size_t cells() const
    {
        return cells_;
    }

  private:
    CsvRow &append(const std::string &text);

    std::string text_;
    std::size_t cells_ = 0;
};

// Writes one table. The file has its name from finish() on (part_file.hpp); a writer that is destroyed before leaves
// NAME.part, in which every row is whole.
class CsvWriter
{
  public:
    // Start a table: `comments` without their `#`, then the header row.
    CsvWriter(const std::filesystem::path &path, const std::vector<std::string> &comments,
              const std::vector<std::string> &columns);

    // Go on with the table in `path`.part after its first `kept_bytes` bytes, which end with a whole line
    // (read_csv_part).
    CsvWriter(const std::filesystem::path &path, const std::vector<std::string> &columns, std::uintmax_t kept_bytes);

    // Append a row. Throws std::logic_error if it has not one value a column.
    void write(const CsvRow &row);

    // A remark between rows; `text` without its `#`.
    void comment(const std::string &text);

    // An empty line, which parts two curves for gnuplot; readers of tables skip it.
    void blank_line();

    void finish();

  private:
    PartFile file_;
    std::size_t columns_;
};

// One line of a table's body.
struct CsvLine {
    std::string text;          // without the line end
    std::uintmax_t offset = 0; // of its first byte in the file
    bool comment = false;
};

// An unfinished table.
struct CsvPart {
    std::string header;         // the header row, empty if the file has none yet
    std::vector<CsvLine> lines; // the body's whole lines; one that was cut off is left out
};

// Read `path`.part. Throws std::runtime_error that names the file if it cannot be read.
CsvPart read_csv_part(const std::filesystem::path &path);

// The cells of a row.
std::vector<std::string> split_csv(const std::string &row);

// `columns` as a header row.
std::string csv_header(const std::vector<std::string> &columns);

} // namespace twiddle::record
