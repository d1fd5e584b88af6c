// trial.hpp: one trial, 300 control steps of 10 ms, to a rotation.
#pragma once

#include "engine/engine.hpp"
#include "settings/constants.hpp"
#include "sim/world.hpp"

#include <memory>
#include <string>

namespace twiddle::experiment
{

struct TrialResult {
    double rotation_rad = 0; // in the counted direction; 0 after a fault
    std::string fault;       // one sentence if the simulation left the possible; empty otherwise
};

// Whether a hand and an object can be in this state: finite, and not far beyond all that joints and 3 s allow.
bool is_possible(const JointVector &angle_rad, const JointVector &velocity_rad_s, double rotation_rad);

// A control step as an observer sees it, at its end.
struct StepSample {
    int step = 0; // from 1
    JointVector desired_rad{};
    JointVector torque_nm{}; // of the last substep
};

// A world for any number of trials, whoever moves it.
class TrialWorld
{
  public:
    // Throws std::runtime_error for a set-up that hand or object refuse.
    TrialWorld(sim::Stepper stepper, sim::HandModel hand, sim::ObjectSpec object, settings::Setup setup,
               sim::HandHold hold);

    // Run a trial from the start: at every substep torque(const engine::JointReadings &, bool tick), which returns
    // const engine::JointCommands &, says how to move; at each control step's end observer(const StepSample &, const
    // sim::World &) is called.
    template <class Torque, class Observer> TrialResult run(Torque &&torque, Observer &&observer);

    // What it was made with.
    const settings::Setup &setup() const
    {
        return setup_;
    }

  private:
    // A world after a fault cannot be trusted to reset: build it anew.
    TrialResult fault(int step);

    sim::Stepper stepper_;
    sim::HandModel hand_;
    sim::ObjectSpec object_;
    settings::Setup setup_;
    sim::HandHold hold_;
    std::unique_ptr<sim::World> world_;
    int substeps_;
};

template <class Torque, class Observer> TrialResult TrialWorld::run(Torque &&torque, Observer &&observer)
{
    world_->reset();
    for (int step = 1; step <= trial_steps; ++step) {
        const engine::JointCommands *commands = nullptr;
        for (int substep = 0; substep < substeps_; ++substep) {
            commands = &torque(engine::JointReadings{world_->angles_rad(), world_->velocities_rad_s()}, substep == 0);
            world_->substep(commands->torque_nm);
        }
        if (!is_possible(world_->angles_rad(), world_->velocities_rad_s(), world_->object_rotation_rad()))
            return fault(step);
        const StepSample sample = {step, commands->desired_rad, commands->torque_nm};
        observer(sample, static_cast<const sim::World &>(*world_));
    }
    return {world_->object_rotation_rad() + 0.0, {}}; // a sum with 0 is never -0
}

// A world and a controller, ready for any number of trials of one model on one object.
class TrialRunner
{
  public:
    // Throws std::runtime_error for a set-up that the engine refuses, std::invalid_argument for an unknown model.
    TrialRunner(TrialWorld world, const engine::Engine &engine, const std::string &model, bool with_centre);

    // Run a trial.
    TrialResult run(const engine::Parameters &parameters);

    // Run a trial; at the end of every control step calls observer(const StepSample &, const sim::World &).
    template <class Observer> TrialResult run_observed(const engine::Parameters &parameters, Observer &&observer);

  private:
    TrialWorld world_;
    std::unique_ptr<engine::Controller> controller_;
};

template <class Observer>
TrialResult TrialRunner::run_observed(const engine::Parameters &parameters, Observer &&observer)
{
    controller_->start(parameters);
    return world_.run(
        [this](const engine::JointReadings &readings, bool tick) -> const engine::JointCommands & {
            return controller_->torque(readings, tick);
        },
        observer);
}

} // namespace twiddle::experiment
