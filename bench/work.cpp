#include "work.hpp"

#include "engine/models.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <random>
#include <utility>

namespace twiddle::bench
{

const std::filesystem::path models_dir = TWIDDLE_MODELS;
const std::string mid_a_file = TWIDDLE_MID_A;

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

record::RunSpecification training_run(sim::Stepper stepper, const std::string &object, std::uint32_t trials)
{
    const settings::Setup setup = load_setup(mid_a_file);
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
