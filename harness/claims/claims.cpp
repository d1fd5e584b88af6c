#include "claims.hpp"

#include <algorithm>

namespace twiddle::claims
{

namespace
{

Estimate paper_estimate(const ClaimPart &part, const results::PaperValues &paper)
{
    switch (part.paper) {
    case PaperTable::none:
        return {};
    case PaperTable::table1:
        return part.estimate(grid_of_table1(paper));
    case PaperTable::table2_means:
        return part.estimate(grid_of_table2(paper));
    case PaperTable::table2_spreads: {
        Estimate estimate = part.estimate(grid_of_table2(paper));
        estimate.interval = std::nullopt;
        return estimate;
    }
    case PaperTable::table2_best:
        return part.estimate(grid_of_best(paper));
    }
    return {};
}

PartResult test_part(const ClaimPart &part, const RunGrid &grid, const results::PaperValues &paper)
{
    PartResult result;
    result.part = &part;
    result.estimate = part.estimate(grid);
    result.verdict = verdict_of(result.estimate, part.bound, part.side);
    result.paper = paper_estimate(part, paper);
    result.paper_verdict = verdict_of(result.paper, part.bound, part.side);
    return result;
}

} // namespace

std::string verdict_name(Verdict verdict)
{
    switch (verdict) {
    case Verdict::supported:
        return "supported";
    case Verdict::not_supported:
        return "not supported";
    case Verdict::undecided:
        return "undecided";
    case Verdict::not_measured:
        return "not measured";
    }
    return "";
}

Verdict verdict_of(const Estimate &estimate, double bound, Side side)
{
    if (!estimate.interval) return Verdict::not_measured;
    const bool above = estimate.interval->lower > bound;
    const bool below = estimate.interval->upper < bound;
    if (side == Side::above ? above : below) return Verdict::supported;
    if (side == Side::above ? below : above) return Verdict::not_supported;
    return Verdict::undecided;
}

Verdict overall_verdict(const std::vector<Verdict> &parts)
{
    const auto count = [&](Verdict verdict) { return std::count(parts.begin(), parts.end(), verdict); };
    const auto all = static_cast<std::ptrdiff_t>(parts.size());
    if (count(Verdict::not_supported) > 0) return Verdict::not_supported;
    if (count(Verdict::supported) == all) return Verdict::supported;
    if (count(Verdict::not_measured) == all) return Verdict::not_measured;
    return Verdict::undecided;
}

std::vector<ClaimResult> test_claims(const RunGrid &grid, const results::PaperValues &paper)
{
    std::vector<ClaimResult> results;
    for (const ClaimPart &part : claim_parts()) {
        if (results.empty() || results.back().claim != part.claim) results.push_back({part.claim, {}, {}});
        results.back().parts.push_back(test_part(part, grid, paper));
    }
    for (ClaimResult &result : results) {
        std::vector<Verdict> verdicts;
        for (const PartResult &part : result.parts) {
            verdicts.push_back(part.verdict);
        }
        result.verdict = overall_verdict(verdicts);
    }
    return results;
}

} // namespace twiddle::claims
