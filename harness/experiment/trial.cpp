#include "trial.hpp"

#include <cmath>
#include <stdexcept>

namespace twiddle::experiment
{

namespace
{

// Far beyond any joint's range and any turn that 3 s allow, near enough to stop a simulation that blew up.
constexpr double impossible_joint_rad = 6.3;
constexpr double impossible_rotation_rad = 1000;

} // namespace

bool is_possible(const sim::JointVector &angle_rad, const sim::JointVector &velocity_rad_s, double rotation_rad)
{
    // Comparisons that a value which is not a number fails.
    for (std::size_t i = 0; i < sim::joint_count; ++i) {
        if (!(std::abs(angle_rad[i]) < impossible_joint_rad) || !std::isfinite(velocity_rad_s[i])) return false;
    }
    return std::abs(rotation_rad) < impossible_rotation_rad;
}

TrialRunner::TrialRunner(sim::Stepper stepper, const sim::HandModel &hand, const sim::ObjectSpec &object,
                         const sim::Setup &setup, sim::HandHold hold, const twd_model &model, bool with_centre)
    : stepper_(stepper), hand_(hand), object_(object), setup_(setup), hold_(hold),
      world_(sim::make_world(stepper_, hand_, object_, setup_, hold_)), substeps_(world_->substeps_per_step())
{
    const twd_controller_config config = controller_config(setup_, model, with_centre);
    const twd_error error = twd_controller_init(&controller_, &config);
    if (error != TWD_OK)
        throw std::runtime_error("the controller refuses set-up '" + setup.name + "': " + twd_error_text(error));
}

void TrialRunner::start(const Parameters &parameters)
{
    const twd_error error = twd_controller_start(&controller_, parameters.data(), parameters.size());
    if (error != TWD_OK)
        throw std::invalid_argument(std::string("the controller refuses the parameters: ") + twd_error_text(error));
}

ExpertWeights TrialRunner::weights() const
{
    return expert_weights(*controller_.config.model, controller_.weight);
}

TrialResult TrialRunner::run(const Parameters &parameters)
{
    return run_observed(parameters, [](const StepSample &, const sim::World &) {});
}

TrialResult TrialRunner::fault(int step)
{
    world_ = sim::make_world(stepper_, hand_, object_, setup_, hold_);
    return {0, "the simulation left the possible joint angles in step " + std::to_string(step) +
                   "; the trial counts as 0 rad"};
}

} // namespace twiddle::experiment
