#include <twiddle/skill.h>

enum twd_error twd_skill_start(const struct twd_skill *skill, struct twd_controller *controller)
{
    if (!skill->parameter) return TWD_ERROR_NULL;
    enum twd_error error = twd_setup_config(&skill->setup, &controller->config);
    if (error == TWD_OK) error = twd_controller_init(controller, &controller->config);
    if (error != TWD_OK) return error;
    return twd_controller_start(controller, skill->parameter, skill->parameters);
}
