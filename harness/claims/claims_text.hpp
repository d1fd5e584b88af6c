// claims_text.hpp: the tested claims of a sweep as CSV, in full precision, and as Markdown to read.
#pragma once

#include "claims.hpp"
#include "results/sweep_results.hpp"

#include <string>
#include <vector>

namespace twiddle::claims
{

// The texts of claims.csv, one row a part, and of claims.md.
std::string claims_csv(const results::Sweep &sweep, const std::vector<ClaimResult> &claims);
std::string claims_markdown(const results::Sweep &sweep, const std::vector<ClaimResult> &claims);

// "0.123 (-0.100 to 0.346)", as much of it as there is; "-" without a value.
std::string value_text(const std::optional<double> &value, const std::optional<results::Interval> &interval);

} // namespace twiddle::claims
