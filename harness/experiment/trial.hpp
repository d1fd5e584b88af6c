// trial.hpp: one trial, 300 control steps of 10 ms, from a parameter vector to a rotation.
#pragma once

#include "controller_setup.hpp"
#include "models.hpp"
#include "sim/world.hpp"

#include <twiddle/controller.h>

#include <memory>
#include <string>
#include <vector>

namespace twiddle::experiment
{

constexpr int trial_steps = 300; // of control_step_s; the paper's

// One value in [0, 1] a parameter of the model (model.h).
using Parameters = std::vector<twd_num>;

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

// A world and a controller, ready for any number of trials of one model on one object.
class TrialRunner
{
  public:
    // Throws std::runtime_error for a set-up that hand, object or controller refuse.
    TrialRunner(sim::Stepper stepper, const sim::HandModel &hand, const sim::ObjectSpec &object,
                const sim::Setup &setup, sim::HandHold hold, const twd_model &model, bool with_centre);

    // Give the controller the trial's parameters without a trial. Throws std::invalid_argument if it refuses them.
    void start(const Parameters &parameters);

    // The mixture of CPGs that the last parameters chose.
    ExpertWeights weights() const;

    // Run a trial.
    TrialResult run(const Parameters &parameters);

    // Run a trial; at the end of every control step calls observer(const StepSample &, const sim::World &).
    template <class Observer> TrialResult run_observed(const Parameters &parameters, Observer &&observer);

  private:
    using Angles = std::array<twd_num, TWD_MAX_JOINTS>;
    using Velocities = std::array<twd_rate, TWD_MAX_JOINTS>;
    using Torques = std::array<twd_num, TWD_MAX_JOINTS>;

    // Drive the world through one control step; returns the torques of its last substep.
    Torques advance(const Angles &desired_rad);

    // A world after a fault cannot be trusted to reset: build it anew.
    TrialResult fault(int step);

    sim::Stepper stepper_;
    sim::HandModel hand_;
    sim::ObjectSpec object_;
    sim::Setup setup_;
    sim::HandHold hold_;
    std::unique_ptr<sim::World> world_;
    int substeps_;
    twd_controller controller_{};
};

inline TrialRunner::Torques TrialRunner::advance(const Angles &desired_rad)
{
    Torques torque_nm{};
    for (int substep = 0; substep < substeps_; ++substep) {
        const sim::JointVector angles_rad = world_->angles_rad();
        const sim::JointVector velocities_rad_s = world_->velocities_rad_s();
        Angles angle_rad{};
        Velocities velocity_rad_s{};
        for (std::size_t i = 0; i < sim::joint_count; ++i) {
            angle_rad[i] = twd_num_from_double(angles_rad[i]);
            velocity_rad_s[i] = twd_rate_from_double(velocities_rad_s[i]);
        }
        twd_controller_torque(&controller_, desired_rad.data(), angle_rad.data(), velocity_rad_s.data(),
                              torque_nm.data());
        sim::JointVector applied_nm{};
        for (std::size_t i = 0; i < sim::joint_count; ++i) {
            applied_nm[i] = twd_num_to_double(torque_nm[i]);
        }
        world_->substep(applied_nm);
    }
    return torque_nm;
}

template <class Observer> TrialResult TrialRunner::run_observed(const Parameters &parameters, Observer &&observer)
{
    start(parameters);
    world_->reset();
    Angles desired_rad{};
    for (int step = 1; step <= trial_steps; ++step) {
        twd_controller_tick(&controller_, desired_rad.data());
        const Torques torque_nm = advance(desired_rad);
        if (!is_possible(world_->angles_rad(), world_->velocities_rad_s(), world_->object_rotation_rad()))
            return fault(step);

        StepSample sample;
        sample.step = step;
        for (std::size_t i = 0; i < sim::joint_count; ++i) {
            sample.desired_rad[i] = twd_num_to_double(desired_rad[i]);
            sample.torque_nm[i] = twd_num_to_double(torque_nm[i]);
        }
        observer(sample, static_cast<const sim::World &>(*world_));
    }
    return {world_->object_rotation_rad() + 0.0, {}}; // a sum with 0 is never -0
}

} // namespace twiddle::experiment
