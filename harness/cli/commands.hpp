// commands.hpp: the program's commands, one source each. Each returns the program's exit status.
#pragma once

#include "options.hpp"

#include <string>
#include <vector>

namespace twiddle::cli
{

// The command line as typed, the program's name first.
using Arguments = std::vector<std::string>;

int run_command(const TrainOptions &options, const Arguments &arguments);
int run_command(const SweepOptions &options, const Arguments &arguments);
int run_command(const CalibrateOptions &options, const Arguments &arguments);
int run_command(const ReplayOptions &options, const Arguments &arguments);
int run_command(const RolloutOptions &options, const Arguments &arguments);
int run_command(const ExportOptions &options, const Arguments &arguments);
int run_command(const SummarizeOptions &options, const Arguments &arguments);
int run_command(const CompareClaimsOptions &options, const Arguments &arguments);
int run_command(const ViewOptions &options, const Arguments &arguments);
int run_command(const InfoOptions &options, const Arguments &arguments);

} // namespace twiddle::cli
