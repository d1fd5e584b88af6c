// sweep_tables_text.hpp: the tables of a sweep as CSV, in full precision, and as Markdown to read.
#pragma once

#include "sweep_tables.hpp"

#include <string>
#include <vector>

namespace twiddle::results
{

struct SweepTables {
    std::vector<CentreRow> centre; // Table 1
    std::vector<ModelRow> models;  // Table 2
};

// The texts of table1.csv, table2.csv and tables.md.
std::string table1_csv(const Sweep &sweep, const SweepTables &tables);
std::string table2_csv(const Sweep &sweep, const SweepTables &tables);
std::string tables_markdown(const Sweep &sweep, const SweepTables &tables);

} // namespace twiddle::results
