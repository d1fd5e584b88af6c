// work.hpp: the work that the benchmarks time: trials with random parameters, and training runs. Set-up mid-a, numbers
// in float.
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

// The file of the set-up mid-a, a fixture of the tests.
extern const std::string mid_a_file;

// Set-up `name`, or the one in a file. Throws std::runtime_error with one sentence.
settings::Setup load_setup(const std::string &name, const std::vector<settings::Override> &overrides = {});

// One of each shape.
constexpr std::array<const char *, 3> objects = {"small-sphere", "medium-cylinder", "large-cube"};

// `sets` parameter vectors of `model` with centres, in [0.001, 0.999]; the same for the same seed.
std::vector<engine::Parameters> random_parameters(const std::string &model, std::size_t sets, std::uint32_t seed);

// The welded hand of the repository.
sim::HandModel read_hand();

// Trials of CPG-C in one world.
experiment::TrialRunner make_runner(sim::Stepper stepper, const std::string &object, const settings::Setup &setup);

// A training run of CPG-H, as `twiddle train` does it.
record::RunSpecification training_run(sim::Stepper stepper, const std::string &object, std::uint32_t trials);

// "reference", "fast".
const std::string &name_of(sim::Stepper stepper);

// The peak of this process's resident memory so far, in MB.
double peak_resident_mb();

} // namespace twiddle::bench
