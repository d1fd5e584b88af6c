// claims.hpp: the paper's ten claims, each in parts that one measure can test, and a verdict on each by a rule that was
// fixed before the runs.
//
// A part is supported if the 95 % interval of its value lies wholly on the claim's side of the bound, not supported if
// wholly on the other, else undecided; not measured if the sweep lacks the runs or the files. A claim is not supported
// if any of its parts is not, supported if all are, not measured if none is measured, else undecided.
#pragma once

#include "claim_measures.hpp"
#include "results/paper_values.hpp"

#include <string>
#include <vector>

namespace twiddle::claims
{

enum class Verdict { supported, not_supported, undecided, not_measured };

// "supported", "not supported", "undecided", "not measured".
std::string verdict_name(Verdict verdict);

// Which of the paper's numbers have the same measure; Fig. 5 to 8 print none. Intervals can be had of
// table2_means alone.
enum class PaperTable { none, table1, table2_means, table2_spreads, table2_best };

// One part of a claim. Texts hold no commas, since they stand in claims.csv.
struct ClaimPart {
    int claim = 0;            // 1 to 10
    const char *part = "";    // "2a"
    const char *words = "";   // what is claimed
    const char *measure = ""; // what the value is, in one sentence
    const char *unit = "";    // of value and bound
    double bound = 0;
    Side side = Side::above; // where the value must lie
    PaperTable paper = PaperTable::none;
    Estimate (*estimate)(const RunGrid &grid) = nullptr;
};

// All parts, in order.
const std::vector<ClaimPart> &claim_parts();

// The ten claims in words.
const std::vector<std::string> &claims_in_words();

struct PartResult {
    const ClaimPart *part = nullptr;
    Estimate estimate;
    Verdict verdict = Verdict::not_measured;
    Estimate paper; // the same measure on the paper's tables; without value where they do not have it
    Verdict paper_verdict = Verdict::not_measured; // on that, by the same rule
};

struct ClaimResult {
    int claim = 0;
    Verdict verdict = Verdict::not_measured;
    std::vector<PartResult> parts;
};

Verdict verdict_of(const Estimate &estimate, double bound, Side side);

// The verdict on a claim from those on its parts, of which there is at least one.
Verdict overall_verdict(const std::vector<Verdict> &parts);

// The claims, in order, on the runs of a sweep.
std::vector<ClaimResult> test_claims(const RunGrid &grid, const results::PaperValues &paper);

} // namespace twiddle::claims
