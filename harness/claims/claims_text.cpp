#include "claims_text.hpp"

#include "results/results_text.hpp"

namespace twiddle::claims
{

namespace
{

const char *side_text(Side side)
{
    return side == Side::above ? "above" : "below";
}

results::Texts csv_row(const ClaimResult &claim, const PartResult &result)
{
    const ClaimPart &part = *result.part;
    const Estimate &estimate = result.estimate;
    const std::optional<results::Interval> &interval = estimate.interval;
    const std::optional<results::Interval> &paper_interval = result.paper.interval;
    return {std::to_string(part.claim),
            part.part,
            part.words,
            part.measure,
            part.unit,
            results::full(estimate.value),
            interval ? results::full(interval->lower) : "",
            interval ? results::full(interval->upper) : "",
            side_text(part.side),
            results::full(part.bound),
            results::full(result.paper.value),
            paper_interval ? results::full(paper_interval->lower) : "",
            paper_interval ? results::full(paper_interval->upper) : "",
            std::to_string(estimate.objects),
            std::to_string(estimate.runs),
            verdict_name(result.verdict),
            verdict_name(claim.verdict),
            estimate.missing};
}

std::string overview(const std::vector<ClaimResult> &claims)
{
    std::vector<results::Texts> rows;
    for (const ClaimResult &claim : claims) {
        std::string parts;
        for (const PartResult &part : claim.parts) {
            if (claim.parts.size() > 1)
                parts += (parts.empty() ? "" : "; ") + std::string(part.part->part) + " " + verdict_name(part.verdict);
        }
        rows.push_back({std::to_string(claim.claim), claims_in_words()[static_cast<std::size_t>(claim.claim - 1)],
                        verdict_name(claim.verdict), parts});
    }
    return results::markdown_table({"claim", "the paper says", "verdict", "its parts"}, rows);
}

std::string parts_table(const std::vector<ClaimResult> &claims)
{
    std::vector<results::Texts> rows;
    for (const ClaimResult &claim : claims) {
        for (const PartResult &result : claim.parts) {
            const ClaimPart &part = *result.part;
            rows.push_back({part.part, part.words, value_text(result.estimate.value, result.estimate.interval),
                            std::string(side_text(part.side)) + " " + results::fixed(part.bound, 3) + " " + part.unit,
                            value_text(result.paper.value, result.paper.interval) +
                                (result.paper.interval ? " " + verdict_name(result.paper_verdict) : ""),
                            std::to_string(result.estimate.runs) + " (" + std::to_string(result.estimate.objects) + ")",
                            verdict_name(result.verdict)});
        }
    }
    return results::markdown_table(
        {"part", "claim", "ours (95 % interval)", "the claim's side", "the paper's", "runs (objects)", "verdict"},
        rows);
}

// The measure of a part, what is missing for it, and its components.
std::string measure_text(const PartResult &result)
{
    const Estimate &estimate = result.estimate;
    std::string text = "- **" + std::string(result.part->part) + "**: " + result.part->measure + ".";
    if (!estimate.missing.empty()) text += " Not measured: " + estimate.missing + ".";
    if (estimate.components.size() < 2) return text + "\n";
    std::string list;
    for (const Component &component : estimate.components) {
        list += (list.empty() ? " " : "; ") + component.name + " " + value_text(component.value, component.interval);
    }
    return text + "\n  Each:" + list + ".\n";
}

std::string measures(const std::vector<ClaimResult> &claims)
{
    std::string text;
    for (const ClaimResult &claim : claims) {
        for (const PartResult &part : claim.parts) {
            text += measure_text(part);
        }
    }
    return text;
}

std::string rules(const results::Sweep &sweep)
{
    results::Texts lines;
    lines.push_back(
        "verdict: supported if the 95 % interval lies wholly on the claim's side of the bound, not supported if "
        "wholly on the other, else undecided; not measured if runs or files are missing. Bounds were fixed "
        "before the runs. A claim of several parts is not supported if any part is not, supported if all are, "
        "not measured if none is measured, else undecided.");
    lines.push_back("rotation: " + results::rotation_text(sweep) +
                    ". Only the sweep's own settings count, no variant.");
    lines.push_back(
        "interval: objects and models are fixed, the seed is drawn. Each cell's share of the variance is the "
        "jackknife's over its runs; the interval is value -+ t SE with Student's t of Welch and "
        "Satterthwaite's degrees of freedom. For one cell's mean it is Student's interval, for the difference of "
        "two Welch's. A percentile bootstrap would cover the mean of four runs 81 times in 100 only.");
    lines.push_back(
        "every: where a claim is about every object or model, the value is the one least in the claim's favour, "
        "and so are the interval's ends: supported if all intervals lie on the claim's side, not supported if one "
        "lies wholly on the other. With many at once, chance alone may put one there: each has 2.5 % for it.");
    lines.push_back(
        "share of the objects (2a, 2b): percentile bootstrap of the count, " +
        std::to_string(results::bootstrap_resamples) +
        " resamples of the runs in each cell from a fixed seed; resampled means are widened so that a cell's "
        "own interval is Student's. The best of a resample is never above the best run seen, so that 2b leans "
        "to what was seen.");
    lines.push_back(
        "trials to 80 % (3a): the first trial at which the mean of the last 100 rotations (of shorter runs: the last "
        "fiftieth of the run) reaches 80 % of the run's own final rotation; all trials for a run that turned the "
        "object backwards. A model that learns little reaches its own level soon; 3b asks for the level too.");
    lines.push_back("bounds: 2a more than half of the objects; 2b seven of nine, since the paper excepts two; 6a, 6b, "
                    "6c and 7a halfway between the two extremes (one finger and both alike, in phase and opposite, one "
                    "CPG and all three alike); 7c a tenth; 8a, 8b a third of the learnable range, by which two "
                    "frequencies drawn evenly from it differ on average.");
    lines.push_back("fingers (6a, 6c): a step's forward turn counts for the fingers that press on the object at its "
                    "end, in proportion to their normal forces.");
    lines.push_back(
        "8b is partly true by construction: lone CPG-M and CPG-S have no parameter for the frequency and take "
        "it from the set-up.");
    lines.push_back("the paper's: the same measure on the values of its tables, whose unit is not stated; - where it "
                    "prints no numbers. Where Table 2's mean and sd are enough, also its interval and the verdict on "
                    "the paper's own runs by the same rule, taking the sd for that of four runs, as it states.");
    std::string text;
    for (const std::string &line : lines) {
        text += "- " + line + "\n";
    }
    return text;
}

} // namespace

std::string value_text(const std::optional<double> &value, const std::optional<results::Interval> &interval)
{
    if (!value) return "-";
    if (!interval) return results::fixed(*value, 3);
    return results::fixed(*value, 3) + " (" + results::fixed(interval->lower, 3) + " to " +
           results::fixed(interval->upper, 3) + ")";
}

std::string claims_csv(const results::Sweep &sweep, const std::vector<ClaimResult> &claims)
{
    std::vector<results::Texts> rows;
    for (const ClaimResult &claim : claims) {
        for (const PartResult &result : claim.parts) {
            rows.push_back(csv_row(claim, result));
        }
    }
    return results::csv_text(
        {"the paper's claims; one row a part; claims.md has the rules", results::rotation_text(sweep),
         "lower, upper: 95 % interval of value; side, bound: where value must lie for the claim",
         "paper: the same measure on the paper's tables, with its interval where they give four runs' sd; "
         "objects, runs: that value rests on",
         "verdict: on the part; claim_verdict: on the whole claim", results::origin_text(sweep)},
        {"claim", "part", "words", "measure", "unit", "value", "lower", "upper", "side", "bound", "paper",
         "paper_lower", "paper_upper", "objects", "runs", "verdict", "claim_verdict", "missing"},
        rows);
}

std::string claims_markdown(const results::Sweep &sweep, const std::vector<ClaimResult> &claims)
{
    return "# Claims tested on the sweep " + sweep.name + "\n\n" + results::origin_text(sweep) +
           ".\n\n## Verdicts\n\n" + overview(claims) + "\n## Numbers\n\n" + parts_table(claims) + "\n## Measures\n\n" +
           measures(claims) + "\n## Rules\n\n" + rules(sweep);
}

} // namespace twiddle::claims
