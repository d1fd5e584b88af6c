// paper_values.hpp: the values of the paper's two tables, as printed: a digit more or less would be another claim.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace twiddle::results
{

// A cell of the paper's Table 2. The rewards' unit is not stated.
struct PaperCell {
    std::string mean;
    std::string sd;
    std::string best;
};

struct PaperValues {
    std::vector<std::string> objects;                                     // in the paper's order, e.g. "small-sphere"
    std::map<std::pair<std::string, bool>, std::string> reward;           // Table 1, by object and centre: CPG-H
    std::map<std::pair<std::string, std::string>, PaperCell> with_centre; // Table 2, by object and model
};

// Read table1.csv and table2.csv of `folder` (plots/paper). Throws std::runtime_error that names the file
// and what is wrong.
PaperValues read_paper_values(const std::filesystem::path &folder);

} // namespace twiddle::results
