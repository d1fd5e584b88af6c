#include "results_text.hpp"

#include "record/versions.hpp"

#include <algorithm>

namespace twiddle::results
{

namespace
{

// Which trials count.
std::string last_trials_text(const Sweep &sweep)
{
    const std::string trials = std::to_string(sweep.trials);
    if (sweep.trials < most_last_trials)
        return "over all " + trials + " trials, since the runs have fewer than " + std::to_string(most_last_trials);
    return "over the last " + std::to_string(last_trials(sweep)) + " of " + trials + " trials";
}

} // namespace

std::string rotation_text(const Sweep &sweep)
{
    return "a run counts with its mean rotation in rad " + last_trials_text(sweep);
}

std::string origin_text(const Sweep &sweep)
{
    return "sweep " + sweep.name + " of " + sweep.version + ", summarized by " + record::version_line();
}

std::string model_text(const std::string &model, bool centre)
{
    std::string name = model;
    std::transform(name.begin(), name.end(), name.begin(), [](char letter) {
        return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 32) : letter;
    });
    return name + (centre ? "" : " without centre");
}

} // namespace twiddle::results
