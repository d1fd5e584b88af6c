#include "control_loop.hpp"

#include <stdexcept>

namespace twiddle::experiment
{

ControlLoop::ControlLoop(const twd_controller_config &config, const std::string &setup_name)
{
    const twd_error error = twd_controller_init(&controller_, &config);
    if (error != TWD_OK)
        throw std::runtime_error("the controller refuses set-up '" + setup_name + "': " + twd_error_text(error));
}

void ControlLoop::start(const Parameters &parameters)
{
    const twd_error error = twd_controller_start(&controller_, parameters.data(), parameters.size());
    if (error != TWD_OK)
        throw std::invalid_argument(std::string("the controller refuses the parameters: ") + twd_error_text(error));
}

ExpertWeights ControlLoop::weights() const
{
    return expert_weights(*controller_.config.model, controller_.weight);
}

} // namespace twiddle::experiment
