// results_text.hpp: what all tables of a sweep's results say in the same words.
#pragma once

#include "sweep_results.hpp"
#include "table_text.hpp"

#include <string>

namespace twiddle::results
{

// Which trials a run's rotation is the mean of.
std::string rotation_text(const Sweep &sweep);

// Where the numbers come from: the sweep, and the programs that made and summarized it.
std::string origin_text(const Sweep &sweep);

// "CPG-H", "CPG-H without centre".
std::string model_text(const std::string &model, bool centre);

} // namespace twiddle::results
