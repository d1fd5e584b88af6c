#include "claims_comparison.hpp"

#include "claims_text.hpp"
#include "record/csv.hpp"
#include "record/number_text.hpp"
#include "results/table_text.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace twiddle::claims
{

namespace
{

TestedPart part_of(const results::Texts &columns, const results::Texts &cells)
{
    const auto cell = [&](const char *name) {
        const auto found = std::find(columns.begin(), columns.end(), name);
        if (found == columns.end()) throw std::runtime_error(std::string("has no column '") + name + "'");
        return cells[static_cast<std::size_t>(found - columns.begin())];
    };
    std::optional<results::Interval> interval;
    const std::optional<double> lower = record::parse_number(cell("lower"));
    const std::optional<double> upper = record::parse_number(cell("upper"));
    if (lower && upper) interval = results::Interval{*lower, *upper};
    return {cell("claim"),   cell("part"),
            cell("words"),   value_text(record::parse_number(cell("value")), interval),
            cell("verdict"), cell("claim_verdict")};
}

std::vector<TestedPart> parts_in(std::ifstream &file)
{
    results::Texts columns;
    std::vector<TestedPart> parts;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') continue;
        const results::Texts cells = record::split_csv(line);
        if (columns.empty()) {
            columns = cells;
            continue;
        }
        if (cells.size() != columns.size()) throw std::runtime_error("has a row that is not whole: " + line);
        parts.push_back(part_of(columns, cells));
    }
    if (parts.empty()) throw std::runtime_error("holds no claims");
    return parts;
}

void require_same_parts(const std::vector<TestedClaims> &sweeps)
{
    const auto same = [](const TestedPart &a, const TestedPart &b) { return a.part == b.part && a.words == b.words; };
    for (const TestedClaims &sweep : sweeps) {
        if (!std::equal(sweep.parts.begin(), sweep.parts.end(), sweeps[0].parts.begin(), sweeps[0].parts.end(), same))
            throw std::runtime_error("the claims of " + sweeps[0].name + " and " + sweep.name +
                                     " were tested in different parts; run summarize on both with one version");
    }
}

results::Texts header(const results::Texts &first, const std::vector<TestedClaims> &sweeps)
{
    results::Texts columns = first;
    for (const TestedClaims &sweep : sweeps) {
        columns.push_back(sweep.name);
    }
    columns.emplace_back("holds");
    return columns;
}

// A table of `text` of one part in every sweep, and of where its `verdict` holds.
template <class Text>
results::Texts row_of(results::Texts first, const std::vector<TestedClaims> &sweeps, std::size_t part,
                      std::string TestedPart::*verdict, const Text &text)
{
    std::vector<std::string> verdicts;
    for (const TestedClaims &sweep : sweeps) {
        first.push_back(text(sweep.parts[part]));
        verdicts.push_back(sweep.parts[part].*verdict);
    }
    first.push_back(where_it_holds(verdicts));
    return first;
}

} // namespace

std::vector<TestedPart> read_claims_csv(const std::filesystem::path &path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read '" + path.string() + "'");
    try {
        return parts_in(file);
    } catch (const std::runtime_error &error) {
        throw std::runtime_error("'" + path.string() + "' " + error.what());
    }
}

std::string where_it_holds(const std::vector<std::string> &verdicts)
{
    const auto supported = std::count(verdicts.begin(), verdicts.end(), "supported");
    const auto not_supported = std::count(verdicts.begin(), verdicts.end(), "not supported");
    const auto all = static_cast<std::ptrdiff_t>(verdicts.size());
    if (supported == all) return "in every set-up";
    if (not_supported == all) return "in none";
    return supported > 0 && not_supported > 0 ? "set-up decides" : "open";
}

std::string comparison_markdown(const std::vector<TestedClaims> &sweeps)
{
    require_same_parts(sweeps);
    std::vector<results::Texts> claims;
    std::vector<results::Texts> parts;
    const std::vector<TestedPart> &listed = sweeps.at(0).parts;
    for (std::size_t i = 0; i < listed.size(); ++i) {
        if (i == 0 || listed[i].claim != listed[i - 1].claim) {
            const std::size_t place = claims.size();
            claims.push_back(row_of({listed[i].claim, claims_in_words().at(place)}, sweeps, i,
                                    &TestedPart::claim_verdict,
                                    [](const TestedPart &part) { return part.claim_verdict; }));
        }
        parts.push_back(row_of({listed[i].part, listed[i].words}, sweeps, i, &TestedPart::verdict,
                               [](const TestedPart &part) { return part.value + " " + part.verdict; }));
    }
    return results::markdown_table(header({"claim", "the paper says"}, sweeps), claims) + "\n" +
           results::markdown_table(header({"part", "claim"}, sweeps), parts);
}

} // namespace twiddle::claims
