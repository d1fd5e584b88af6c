// trial.hpp: one trial, 300 control steps of 10 ms, to a rotation.
#pragma once

#include "control_loop.hpp"
#include "controller_setup.hpp"
#include "sim/world.hpp"

#include <memory>
#include <string>

namespace twiddle::experiment
{

constexpr int trial_steps = 300; // of control_step_s; the paper's

struct TrialResult {
    double rotation_rad = 0; // in the counted direction; 0 after a fault
    std::string fault;       // one sentence if the simulation left the possible; empty otherwise
};

// Whether a hand and an object can be in this state: finite, and not far beyond all that joints and 3 s allow.
bool is_possible(const sim::JointVector &angle_rad, const sim::JointVector &velocity_rad_s, double rotation_rad);

// A control step as an observer sees it, at its end.
struct StepSample {
    int step = 0; // from 1
    sim::JointVector desired_rad{};
    sim::JointVector torque_nm{}; // of the last substep
};

// A world for any number of trials, whoever moves it.
class TrialWorld
{
  public:
    // Throws std::runtime_error for a set-up that hand or object refuse.
    TrialWorld(sim::Stepper stepper, sim::HandModel hand, sim::ObjectSpec object, sim::Setup setup, sim::HandHold hold);

    // Run a trial from the start: advance(sim::World &, int substeps), which returns StepCommands, moves the world
    // through each control step; at its end observer(const StepSample &, const sim::World &) is called.
    template <class Advance, class Observer> TrialResult run(Advance &&advance, Observer &&observer);

    // What it was made with.
    const sim::Setup &setup() const
    {
        return setup_;
    }

  private:
    // A world after a fault cannot be trusted to reset: build it anew.
    TrialResult fault(int step);

    sim::Stepper stepper_;
    sim::HandModel hand_;
    sim::ObjectSpec object_;
    sim::Setup setup_;
    sim::HandHold hold_;
    std::unique_ptr<sim::World> world_;
    int substeps_;
};

template <class Advance, class Observer> TrialResult TrialWorld::run(Advance &&advance, Observer &&observer)
{
    world_->reset();
    for (int step = 1; step <= trial_steps; ++step) {
        const StepCommands commands = advance(*world_, substeps_);
        if (!is_possible(world_->angles_rad(), world_->velocities_rad_s(), world_->object_rotation_rad()))
            return fault(step);
        const StepSample sample = {step, commands.desired_rad, commands.torque_nm};
        observer(sample, static_cast<const sim::World &>(*world_));
    }
    return {world_->object_rotation_rad() + 0.0, {}}; // a sum with 0 is never -0
}

// A world and a controller, ready for any number of trials of one model on one object.
class TrialRunner
{
  public:
    // Throws std::runtime_error for a set-up that hand, object or controller refuse.
    TrialRunner(sim::Stepper stepper, const sim::HandModel &hand, const sim::ObjectSpec &object,
                const sim::Setup &setup, sim::HandHold hold, const twd_model &model, bool with_centre);
    TrialRunner(TrialWorld world, const twd_model &model, bool with_centre);

    // Run a trial.
    TrialResult run(const Parameters &parameters);

    // Run a trial; at the end of every control step calls observer(const StepSample &, const sim::World &).
    template <class Observer> TrialResult run_observed(const Parameters &parameters, Observer &&observer);

  private:
    TrialWorld world_;
    ControlLoop loop_;
};

template <class Observer> TrialResult TrialRunner::run_observed(const Parameters &parameters, Observer &&observer)
{
    loop_.start(parameters);
    return world_.run([this](sim::World &world, int substeps) { return loop_.advance(world, substeps); }, observer);
}

} // namespace twiddle::experiment
