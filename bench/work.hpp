// work.hpp: the work that the benchmarks time: trials with random parameters, and training runs. Set-up mid-a.
#pragma once

#include "experiment/trial.hpp"
#include "record/run_json.hpp"
#include "settings/setup.hpp"
#include "sim/world.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::bench
{

extern const std::filesystem::path models_dir;

// One of each shape.
constexpr std::array<const char *, 3> objects = {"small-sphere", "medium-cylinder", "large-cube"};

// `sets` parameter vectors of `model` with centres, in [0.001, 0.999]; the same for the same seed.
std::vector<experiment::Parameters> random_parameters(const twd_model &model, std::size_t sets, std::uint32_t seed);

// Trials of CPG-C in one world. Throws std::runtime_error for overrides that are none.
experiment::TrialRunner make_runner(sim::Stepper stepper, const std::string &object,
                                    const std::vector<settings::Override> &overrides = {});

// A training run of CPG-H, as `twiddle train` does it.
record::RunSpecification training_run(sim::Stepper stepper, const std::string &object, std::uint32_t trials);

// "reference", "fast".
const std::string &name_of(sim::Stepper stepper);

// The peak of this process's resident memory so far, in MB.
double peak_resident_mb();

} // namespace twiddle::bench
