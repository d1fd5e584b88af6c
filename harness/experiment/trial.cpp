#include "trial.hpp"

#include <cmath>
#include <utility>

namespace twiddle::experiment
{

namespace
{

// Far beyond any joint's range and any turn that 3 s allow, near enough to stop a simulation that blew up.
constexpr double impossible_joint_rad = 6.3;
constexpr double impossible_rotation_rad = 1000;

} // namespace

bool is_possible(const JointVector &angle_rad, const JointVector &velocity_rad_s, double rotation_rad)
{
    // Comparisons that a value which is not a number fails.
    for (std::size_t i = 0; i < joint_count; ++i) {
        if (!(std::abs(angle_rad[i]) < impossible_joint_rad) || !std::isfinite(velocity_rad_s[i])) return false;
    }
    return std::abs(rotation_rad) < impossible_rotation_rad;
}

TrialWorld::TrialWorld(sim::Stepper stepper, sim::HandModel hand, sim::ObjectSpec object, settings::Setup setup,
                       sim::HandHold hold)
    : stepper_(stepper), hand_(std::move(hand)), object_(std::move(object)), setup_(std::move(setup)), hold_(hold),
      world_(sim::make_world(stepper_, hand_, object_, setup_, hold_)), substeps_(world_->substeps_per_step())
{
}

TrialResult TrialWorld::fault(int step)
{
    world_ = sim::make_world(stepper_, hand_, object_, setup_, hold_);
    return {0, "the simulation left the possible joint angles in step " + std::to_string(step) +
                   "; the trial counts as 0 rad"};
}

TrialRunner::TrialRunner(TrialWorld world, const engine::Engine &engine, const std::string &model, bool with_centre)
    : world_(std::move(world)), controller_(engine.make_controller({world_.setup(), model, with_centre}))
{
}

TrialResult TrialRunner::run(const engine::Parameters &parameters)
{
    return run_observed(parameters, [](const StepSample &, const sim::World &) {});
}

} // namespace twiddle::experiment
