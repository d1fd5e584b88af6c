#include "control_loop.hpp"

#include <stdexcept>
#include <string>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

ControlLoop::ControlLoop(const ControllerSetup &setup)
{
    const twd_controller_config config = controller_config(setup);
    const twd_error error = twd_controller_init(&controller_, &config);
    if (error != TWD_OK)
        throw std::runtime_error("the controller refuses set-up '" + setup.setup.name + "': " + twd_error_text(error));
}

void ControlLoop::start(const Parameters &parameters)
{
    start_with(library_numbers(parameters));
}

void ControlLoop::start_with(const std::vector<twd_num> &parameters)
{
    const twd_error error = twd_controller_start(&controller_, parameters.data(), parameters.size());
    if (error != TWD_OK)
        throw std::invalid_argument(std::string("the controller refuses the parameters: ") + twd_error_text(error));
}

const JointCommands &ControlLoop::torque(const JointReadings &readings, bool tick)
{
    if (tick) {
        twd_controller_tick(&controller_, desired_rad_.data());
        commands_.desired_rad = joint_vector(desired_rad_);
    }
    const LibraryReadings numbers = library_readings(readings);
    JointNumbers torque_nm;
    twd_controller_torque(&controller_, desired_rad_.data(), numbers.angle_rad.data(), numbers.velocity_rad_s.data(),
                          torque_nm.data());
    commands_.torque_nm = joint_vector(torque_nm);
    return commands_;
}

ExpertWeights ControlLoop::weights() const
{
    return expert_weights(*controller_.config.model, controller_.weight);
}

ExpertWeights expert_weights(const twd_model &model, const twd_num *weight)
{
    static constexpr std::array<const twd_topology *, expert_count> experts = {&twd_cpg_c, &twd_cpg_m, &twd_cpg_s};
    ExpertWeights weights{};
    for (int k = 0; k < model.cpgs; ++k) {
        for (std::size_t expert = 0; expert < expert_count; ++expert) {
            if (model.topology[k] == experts[expert]) weights[expert] = twd_num_to_double(weight[k]);
        }
    }
    return weights;
}

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
