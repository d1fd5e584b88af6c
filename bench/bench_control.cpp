// Speed of the full loop, of a whole training run, and of the controller's and the learner's parts, on one core, with
// numbers in float, for the set-up paper-negated. Items are control steps, or calls of the part that is named.
#include "work.hpp"

#include "engine/controller_setup.hpp"
#include "engine/library_numbers.hpp"
#include "experiment/training.hpp"

#include <twiddle/controller.h>
#include <twiddle/convert.h>
#include <twiddle/learner.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>
#include <vector>

namespace
{

using namespace twiddle;
using namespace twiddle::experiment;
using engine::TWD_BUILD_NAMESPACE::library_numbers;

constexpr std::uint32_t seed = 1;

// Trials of CPG-C with random parameters: controller, torques at every substep, and the world.
void full_loop(benchmark::State &state, sim::Stepper stepper, const char *object)
{
    TrialRunner runner = bench::make_runner(stepper, object, bench::load_setup(bench::speed_setup));
    const auto sets = bench::random_parameters("cpg-c", 64, seed);
    std::size_t next = 0;
    while (state.KeepRunning())
        benchmark::DoNotOptimize(runner.run(sets[next++ % sets.size()]).rotation_rad);
    state.SetItemsProcessed(state.iterations() * trial_steps);
}

// A training run of CPG-H from its first trial to its last.
void training_run(benchmark::State &state, sim::Stepper stepper, const char *object)
{
    constexpr std::uint32_t trials = 5000;
    while (state.KeepRunning()) {
        Training run(bench::training_run(stepper, object, trials), bench::models_dir);
        for (std::uint32_t trial = 0; trial < trials; ++trial)
            benchmark::DoNotOptimize(run.run_trial().rotation_rad);
    }
    state.SetItemsProcessed(state.iterations() * trials * trial_steps);
}

engine::AgentSetup agent_setup_of_h()
{
    return {{bench::load_setup(bench::speed_setup), "cpg-h", true}, 5000, seed};
}

// A controller of CPG-H, whose three CPGs all run.
twd_controller controller_of_h()
{
    const twd_controller_config config = engine::TWD_BUILD_NAMESPACE::controller_config(agent_setup_of_h().controller);
    twd_controller controller{};
    if (twd_controller_init(&controller, &config) != TWD_OK) std::abort();
    const std::vector<twd_num> parameters = library_numbers(bench::random_parameters("cpg-h", 1, seed).front());
    if (twd_controller_start(&controller, parameters.data(), parameters.size()) != TWD_OK) std::abort();
    return controller;
}

void controller_tick(benchmark::State &state)
{
    twd_controller controller = controller_of_h();
    std::array<twd_num, TWD_MAX_JOINTS> desired_rad{};
    while (state.KeepRunning()) {
        twd_controller_tick(&controller, desired_rad.data());
        benchmark::DoNotOptimize(desired_rad);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(controller_tick);

void controller_torque(benchmark::State &state)
{
    twd_controller controller = controller_of_h();
    const std::array<twd_num, TWD_MAX_JOINTS> desired_rad = {TWD_NUM(0.7), TWD_NUM(0.1), TWD_NUM(0.8), TWD_NUM(1.1)};
    std::array<twd_num, TWD_MAX_JOINTS> angle_rad = {TWD_NUM(0.6), TWD_NUM(0.0), TWD_NUM(0.9), TWD_NUM(1.2)};
    const std::array<twd_rate, TWD_MAX_JOINTS> velocity_rad_s = {TWD_RATE(1), TWD_RATE(-1), TWD_RATE(2), TWD_RATE(-2)};
    std::array<twd_num, TWD_MAX_JOINTS> torque_nm{};
    while (state.KeepRunning()) {
        benchmark::DoNotOptimize(angle_rad); // as if measured anew
        twd_controller_torque(&controller, desired_rad.data(), angle_rad.data(), velocity_rad_s.data(),
                              torque_nm.data());
        benchmark::DoNotOptimize(torque_nm);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(controller_torque);

// One trial of the learner of CPG-H: exploring, and learning from a reward.
void learner_act_and_learn(benchmark::State &state)
{
    const engine::AgentSetup setup = agent_setup_of_h();
    const twd_learner_config config = engine::TWD_BUILD_NAMESPACE::learner_config(setup);
    twd_learner learner{};
    if (twd_learner_init(&learner, &config) != TWD_OK) std::abort();
    const sim::ObjectSpec object = sim::read_object(bench::models_dir, "small-sphere");
    const std::vector<twd_num> input =
        library_numbers(engine::TWD_BUILD_NAMESPACE::learner_input(object, setup.controller.setup.learner));
    std::vector<twd_num> parameters(config.units);
    while (state.KeepRunning()) {
        twd_learner_act(&learner, input.data(), parameters.data());
        benchmark::DoNotOptimize(twd_learner_learn(&learner, twd_wide_of_num(parameters.front())));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(learner_act_and_learn);

void for_3_s(benchmark::internal::Benchmark *full_loop)
{
    full_loop->Unit(benchmark::kMillisecond)->MinTime(3);
}

void one_run(benchmark::internal::Benchmark *training_run)
{
    training_run->Unit(benchmark::kSecond)->Iterations(1);
}

// Unformatted, since spaces around the slashes would be spaces in the names.
// clang-format off
BENCHMARK_CAPTURE(full_loop, fast/small_sphere, sim::Stepper::fast, "small-sphere")->Apply(for_3_s);
BENCHMARK_CAPTURE(full_loop, fast/medium_cylinder, sim::Stepper::fast, "medium-cylinder")->Apply(for_3_s);
BENCHMARK_CAPTURE(full_loop, fast/large_cube, sim::Stepper::fast, "large-cube")->Apply(for_3_s);
BENCHMARK_CAPTURE(full_loop, reference/small_sphere, sim::Stepper::reference, "small-sphere")->Apply(for_3_s);
BENCHMARK_CAPTURE(full_loop, reference/medium_cylinder, sim::Stepper::reference, "medium-cylinder")->Apply(for_3_s);
BENCHMARK_CAPTURE(full_loop, reference/large_cube, sim::Stepper::reference, "large-cube")->Apply(for_3_s);
BENCHMARK_CAPTURE(training_run, fast/small_sphere, sim::Stepper::fast, "small-sphere")->Apply(one_run);
BENCHMARK_CAPTURE(training_run, fast/medium_cylinder, sim::Stepper::fast, "medium-cylinder")->Apply(one_run);
BENCHMARK_CAPTURE(training_run, fast/large_cube, sim::Stepper::fast, "large-cube")->Apply(one_run);
// A minute.
BENCHMARK_CAPTURE(training_run, reference/small_sphere, sim::Stepper::reference, "small-sphere")->Apply(one_run);
// clang-format on

} // namespace
