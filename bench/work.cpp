#include "work.hpp"

#include "engine/models.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <random>

namespace twiddle::bench
{

namespace
{

constexpr const char *setup_name = "mid-a";

} // namespace

const std::filesystem::path models_dir = TWIDDLE_MODELS;

std::vector<experiment::Parameters> random_parameters(const twd_model &model, std::size_t sets, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.001, 0.999);
    std::vector<experiment::Parameters> drawn(sets, experiment::Parameters(twd_model_parameters(&model, true)));
    for (experiment::Parameters &set : drawn)
        std::generate(set.begin(), set.end(), [&] { return twd_num_from_double(uniform(random)); });
    return drawn;
}

experiment::TrialRunner make_runner(sim::Stepper stepper, const std::string &object,
                                    const std::vector<settings::Override> &overrides)
{
    return {stepper,
            sim::read_hand_model(models_dir / "icub_right_hand.urdf"),
            sim::read_object(models_dir, object),
            settings::load_setup(models_dir, setup_name, overrides),
            sim::HandHold::welded,
            twd_model_c,
            true};
}

record::RunSpecification training_run(sim::Stepper stepper, const std::string &object, std::uint32_t trials)
{
    record::RunSpecification specification;
    specification.object = object;
    specification.model = "cpg-h";
    specification.seed = 1;
    specification.trials = trials;
    specification.hand = "welded";
    specification.stepper = name_of(stepper);
    specification.setup = setup_name;
    specification.settings = settings::load_setup(models_dir, setup_name).settings;
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
