#include "paper_values.hpp"

#include "record/csv.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace twiddle::results
{

namespace
{

using Row = std::vector<std::string>;

// The rows of a table whose columns must be `columns`.
std::vector<Row> read_rows(const std::filesystem::path &path, const Row &columns)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read '" + path.string() + "'");
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') continue;
        rows.push_back(record::split_csv(line));
        if (rows.back().size() != columns.size() || (rows.size() == 1 && rows.front() != columns))
            throw std::runtime_error("'" + path.string() + "' must have the columns " + record::csv_header(columns));
    }
    if (rows.empty()) throw std::runtime_error("'" + path.string() + "' is empty");
    rows.erase(rows.begin());
    return rows;
}

} // namespace

PaperValues read_paper_values(const std::filesystem::path &folder)
{
    PaperValues paper;
    for (const Row &row : read_rows(folder / "table1.csv", {"size", "shape", "centre", "reward"})) {
        paper.reward[{row[0] + "-" + row[1], row[2] == "true"}] = row[3];
    }
    for (const Row &row : read_rows(folder / "table2.csv", {"size", "shape", "model", "mean", "sd", "best"})) {
        const std::string object = row[0] + "-" + row[1];
        paper.with_centre[{object, row[2]}] = {row[3], row[4], row[5]};
        if (std::find(paper.objects.begin(), paper.objects.end(), object) == paper.objects.end())
            paper.objects.push_back(object);
    }
    return paper;
}

} // namespace twiddle::results
