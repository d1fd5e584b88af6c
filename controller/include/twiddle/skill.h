/* skill.h: a trained skill as constants: a controller's set-up, and the parameters that were learned for it.
 *
 * `twiddle export` writes one as a C header. To play it is one call, then the two of every controller:
 *
 *     once               twd_skill_start
 *     every tick         twd_controller_tick
 *     every substep      twd_controller_torque */
#ifndef TWIDDLE_SKILL_H
#define TWIDDLE_SKILL_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/setup.h>

TWD_BEGIN_DECLARATIONS

/* A skill: const, in flash. */
struct twd_skill {
    struct twd_setup setup;
    /* How long the movement was when it was learned; it may go on for ever. */
    uint16_t trial_ticks;
    /* twd_model_parameters of its model. */
    uint8_t parameters;
    /* [parameters]: in [0, 1]; order: model.h. */
    const twd_num *parameter;
};

/* Prepare `controller` for the skill, and start its movement. Errors: those of twd_setup_config, twd_controller_init
 * and twd_controller_start, and a null table; `controller` is then not to be used. */
enum twd_error twd_skill_start(const struct twd_skill *skill, struct twd_controller *controller);

TWD_END_DECLARATIONS

#endif
