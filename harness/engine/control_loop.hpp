// control_loop.hpp: the C library's controller in this process.
#pragma once

#include "agent.hpp"
#include "controller_setup.hpp"
#include "library_numbers.hpp"

#include <twiddle/controller.h>

#include <vector>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

class ControlLoop final : public Controller
{
  public:
    // Throws std::runtime_error, which names the set-up, for a configuration that the controller refuses.
    explicit ControlLoop(const ControllerSetup &setup);

    void start(const Parameters &parameters) override;
    const JointCommands &torque(const JointReadings &readings, bool tick) override;

    // As start(), with numbers of the library.
    void start_with(const std::vector<twd_num> &parameters);

    // The mixture of CPGs that the last parameters chose.
    ExpertWeights weights() const;

  private:
    twd_controller controller_{};
    // Of the last tick.
    JointNumbers desired_rad_{};
    // The same, and the last torques.
    JointCommands commands_;
};

// The weights of `model`'s own CPGs, as the controller holds them, spread over all three.
ExpertWeights expert_weights(const twd_model &model, const twd_num *weight);

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
