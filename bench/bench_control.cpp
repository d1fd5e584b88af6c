// Speed of the full loop and of its parts on one core, for the default number type, set-up and substeps.
// Items are control steps, or calls of the part that is named.
#include "experiment/training.hpp"
#include "experiment/trial.hpp"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <vector>

namespace
{

using namespace twiddle;
using namespace twiddle::experiment;

const std::filesystem::path models_dir = TWIDDLE_MODELS;

// `count` parameter vectors of `size` values, the same in every run.
std::vector<Parameters> random_parameters(std::size_t count, std::size_t size)
{
    constexpr unsigned seed = 1;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.001, 0.999);
    std::vector<Parameters> sets(count, Parameters(size));
    for (Parameters &set : sets)
        std::generate(set.begin(), set.end(), [&] { return static_cast<twd_num>(uniform(random)); });
    return sets;
}

// The peak of this process's resident memory so far, in MB.
double peak_resident_mb()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024; // Linux counts in KiB
}

// Trials of CPG-C with random parameters: controller, torques at every substep, and the Bullet world.
void full_loop(benchmark::State &state, const char *object)
{
    TrialRunner runner(sim::Stepper::reference, sim::read_hand_model(models_dir / "icub_right_hand.urdf"),
                       sim::read_object(models_dir, object), sim::load_setup(models_dir, "mid-a"),
                       sim::HandHold::welded, twd_model_c, true);
    const auto sets = random_parameters(64, twd_model_parameters(&twd_model_c, true));
    std::size_t next = 0;
    while (state.KeepRunning())
        benchmark::DoNotOptimize(runner.run(sets[next++ % sets.size()]).rotation_rad);
    state.SetItemsProcessed(state.iterations() * trial_steps);
}
BENCHMARK_CAPTURE(full_loop, small_sphere, "small-sphere")->Unit(benchmark::kMillisecond)->MinTime(3);
BENCHMARK_CAPTURE(full_loop, medium_cylinder, "medium-cylinder")->Unit(benchmark::kMillisecond)->MinTime(3);
BENCHMARK_CAPTURE(full_loop, large_cube, "large-cube")->Unit(benchmark::kMillisecond)->MinTime(3);

// A controller of CPG-H, whose three CPGs all run.
twd_controller controller_of_h()
{
    const twd_controller_config config = controller_config(sim::load_setup(models_dir, "mid-a"), twd_model_h, true);
    twd_controller controller{};
    if (twd_controller_init(&controller, &config) != TWD_OK) std::abort();
    const Parameters parameters = random_parameters(1, twd_model_parameters(&twd_model_h, true)).front();
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
    const std::array<twd_num, TWD_MAX_JOINTS> desired_rad = {twd_num(0.7), twd_num(0.1), twd_num(0.8), twd_num(1.1)};
    std::array<twd_num, TWD_MAX_JOINTS> angle_rad = {twd_num(0.6), twd_num(0.0), twd_num(0.9), twd_num(1.2)};
    const std::array<twd_num, TWD_MAX_JOINTS> velocity_rad_s = {twd_num(1), twd_num(-1), twd_num(2), twd_num(-2)};
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
    const sim::LearnerSetup learner = sim::load_setup(models_dir, "mid-a").learner;
    const twd_agent_config config = agent_config(learner, twd_model_h, true, 5000, 1);
    twd_agent agent{};
    if (twd_agent_init(&agent, &config) != TWD_OK) std::abort();
    const LearnerInput input = learner_input(sim::read_object(models_dir, "small-sphere"), learner);
    Parameters parameters(config.units);
    while (state.KeepRunning()) {
        twd_agent_act(&agent, input.data(), parameters.data());
        benchmark::DoNotOptimize(twd_agent_learn(&agent, parameters.front()));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(learner_act_and_learn);

// Trials of a training run of CPG-H; the peak of the process's resident memory, this program's included.
void training(benchmark::State &state)
{
    record::RunSpecification specification;
    specification.object = "small-sphere";
    specification.model = "cpg-h";
    specification.setup = "mid-a";
    specification.settings = sim::load_setup(models_dir, "mid-a").settings;
    specification.trials = 5000;
    Training run(specification, models_dir);
    while (state.KeepRunning())
        benchmark::DoNotOptimize(run.run_trial().rotation_rad);
    state.SetItemsProcessed(state.iterations() * trial_steps);
    state.counters["peak_resident_MB"] = peak_resident_mb();
}
BENCHMARK(training)->Unit(benchmark::kMillisecond)->MinTime(3);

} // namespace
