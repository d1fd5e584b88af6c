// claims_comparison.hpp: the claims of several sweeps side by side: what holds in every set-up, and what
// the set-up decides.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::claims
{

// A row of a claims.csv.
struct TestedPart {
    std::string claim; // "2"
    std::string part;  // "2a"
    std::string words;
    std::string value; // "0.123 (-0.100 to 0.346)"
    std::string verdict;
    std::string claim_verdict;
};

// The claims of one sweep.
struct TestedClaims {
    std::string name; // to head its column
    std::vector<TestedPart> parts;
};

// Read a claims.csv. Throws std::runtime_error with one sentence that names the file and what is wrong.
std::vector<TestedPart> read_claims_csv(const std::filesystem::path &path);

// What verdicts on the same claim in several set-ups come to: "in every set-up" if all are "supported", "in none" if
// all are "not supported", "set-up decides" if some are the one and some the other, else "open".
std::string where_it_holds(const std::vector<std::string> &verdicts);

// A Markdown table of the ten claims and one of their parts, one column a sweep. Throws std::runtime_error if the
// sweeps' claims.csv have not the same parts.
std::string comparison_markdown(const std::vector<TestedClaims> &sweeps);

} // namespace twiddle::claims
