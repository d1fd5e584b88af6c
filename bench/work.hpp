// work.hpp: the work that the benchmarks time: trials with random parameters, and training runs, numbers in
// float.
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

// The set-up of all speed figures: no new default moves it.
extern const std::string speed_setup;

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

// Control steps a second of whole passes through `sets`, for at least `seconds`.
double trials_steps_per_s(experiment::TrialRunner &runner, const std::vector<engine::Parameters> &sets, double seconds);

// The same with every runner on a thread of its own; the sum of what each reaches.
double workers_steps_per_s(std::vector<experiment::TrialRunner> &runners, const std::vector<engine::Parameters> &sets,
                           double seconds);

// A training run of CPG-H, as `twiddle train` does it.
record::RunSpecification training_run(sim::Stepper stepper, const std::string &object, std::uint32_t trials);

// "reference", "fast".
const std::string &name_of(sim::Stepper stepper);

// The peak of this process's resident memory so far, in MB.
double peak_resident_mb();

} // namespace twiddle::bench
