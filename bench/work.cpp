#include "work.hpp"

#include "engine/models.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>
#include <utility>

namespace twiddle::bench
{

const std::filesystem::path models_dir = TWIDDLE_MODELS;
const std::string speed_setup = "paper-negated";

settings::Setup load_setup(const std::string &name, const std::vector<settings::Override> &overrides)
{
    return settings::load_setup(TWIDDLE_SETUPS, name, overrides);
}

std::vector<engine::Parameters> random_parameters(const std::string &model, std::size_t sets, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.001, 0.999);
    std::vector<engine::Parameters> drawn(sets, engine::Parameters(engine::parameter_count(model, true)));
    for (engine::Parameters &set : drawn) {
        std::generate(set.begin(), set.end(), [&] { return uniform(random); });
    }
    return drawn;
}

sim::HandModel read_hand()
{
    return sim::read_hand_model(models_dir / "icub_right_hand.urdf");
}

experiment::TrialRunner make_runner(sim::Stepper stepper, const std::string &object, const settings::Setup &setup)
{
    experiment::TrialWorld world(stepper, read_hand(), sim::read_object(models_dir, object), setup,
                                 sim::HandHold::welded);
    return {std::move(world), engine::engine_of_number("float"), "cpg-c", true};
}

double trials_steps_per_s(experiment::TrialRunner &runner, const std::vector<engine::Parameters> &sets, double seconds)
{
    const auto start = std::chrono::steady_clock::now();
    std::chrono::duration<double> spent_s{};
    std::size_t trials = 0;
    while (spent_s.count() < seconds) {
        for (const engine::Parameters &set : sets)
            runner.run(set);
        trials += sets.size();
        spent_s = std::chrono::steady_clock::now() - start;
    }
    return static_cast<double>(trials) * trial_steps / spent_s.count();
}

double workers_steps_per_s(std::vector<experiment::TrialRunner> &runners, const std::vector<engine::Parameters> &sets,
                           double seconds)
{
    std::vector<double> each(runners.size());
    std::vector<std::thread> threads;
    for (std::size_t w = 0; w < runners.size(); ++w)
        threads.emplace_back([&, w] { each[w] = trials_steps_per_s(runners[w], sets, seconds); });
    for (std::thread &thread : threads)
        thread.join();
    double sum = 0;
    for (const double steps_per_s : each)
        sum += steps_per_s;
    return sum;
}

record::RunSpecification training_run(sim::Stepper stepper, const std::string &object, std::uint32_t trials)
{
    const settings::Setup setup = load_setup(speed_setup);
    record::RunSpecification specification;
    specification.object = object;
    specification.model = "cpg-h";
    specification.seed = 1;
    specification.trials = trials;
    specification.hand = "welded";
    specification.stepper = name_of(stepper);
    specification.number = "float";
    specification.setup = setup.name;
    specification.settings = setup.settings;
    return specification;
}

const std::string &name_of(sim::Stepper stepper)
{
    return sim::stepper_names().at(static_cast<std::size_t>(stepper));
}

double peak_resident_mb()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024; // Linux counts in KiB
}

} // namespace twiddle::bench
