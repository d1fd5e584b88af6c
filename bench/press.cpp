#include "press.hpp"

#include "engine/models.hpp"

#include <chrono>
#include <random>
#include <stdexcept>

namespace twiddle::bench
{

namespace
{

constexpr int settled_steps = trial_steps / 2;

// A random posture: oscillators that stand still at a random share of their joints' ranges.
engine::Parameters random_posture(std::mt19937 &random)
{
    std::uniform_real_distribution<double> uniform(0, 1);
    // Order: nu, R1..4, C1..4 (FEI, AAI, FET, OT), three lags.
    engine::Parameters values(engine::parameter_count("cpg-c", true), 0);
    for (std::size_t centre = 5; centre < 9; ++centre)
        values.at(centre) = uniform(random);
    return values;
}

std::vector<settings::Override> out_of_reach(int fingers, std::vector<settings::Override> overrides)
{
    if (fingers == 0) overrides.emplace_back("object.hinge_x_m", "-0.2");
    return overrides;
}

} // namespace

Press::Press(const std::string &object, int fingers, const std::vector<settings::Override> &overrides,
             std::uint32_t seed)
    : runner_(make_runner(sim::Stepper::fast, object, load_setup(speed_setup, out_of_reach(fingers, overrides))))
{
    constexpr std::size_t wanted = 20, most = 2000;
    std::mt19937 random(seed);
    while (counted_.size() < wanted && tried_ < most) {
        const engine::Parameters posture = random_posture(random);
        ++tried_;
        if (counts(posture, fingers)) counted_.push_back(posture);
    }
    if (counted_.empty())
        throw std::runtime_error("no posture holds " + std::to_string(fingers) + " fingers against " + object);
}

bool Press::counts(const engine::Parameters &posture, int fingers)
{
    bool always = true;
    runner_.run_observed(posture, [&](const experiment::StepSample &sample, const sim::World &world) {
        if (sample.step < settled_steps) return;
        const sim::Observation seen = world.observe();
        const int touching = (seen.index_contact_n > 0) + (seen.thumb_contact_n > 0);
        always = always && touching == fingers;
    });
    return always;
}

double Press::steps_per_s(double seconds)
{
    using Clock = std::chrono::steady_clock;
    std::chrono::duration<double> spent_s{};
    int steps = 0;
    while (spent_s.count() < seconds) {
        for (const engine::Parameters &posture : counted_) {
            Clock::time_point start;
            runner_.run_observed(posture, [&](const experiment::StepSample &sample, const sim::World &) {
                if (sample.step == settled_steps) start = Clock::now();
                if (sample.step == trial_steps) spent_s += Clock::now() - start;
            });
            steps += trial_steps - settled_steps;
        }
    }
    return steps / spent_s.count();
}

} // namespace twiddle::bench
