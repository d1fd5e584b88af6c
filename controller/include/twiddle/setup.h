/* setup.h: what a controller's configuration is made from, as constants.
 *
 * A configuration (controller.h) holds what was worked out from them: each finger's gravity, and gains that are stable
 * at a period. A set-up holds the constants alone, so it can stay in flash, and its words are the same for every
 * compiler. */
#ifndef TWIDDLE_SETUP_H
#define TWIDDLE_SETUP_H

#include <twiddle/controller.h>
#include <twiddle/detail/controller_names.h>

TWD_BEGIN_DECLARATIONS

/* How one joint is driven. */
struct twd_joint_setup {
    struct twd_pd pd;
    /* Effective inertia, from which twd_pd_stable makes gains; 0: they stay as they are. */
    twd_small inertia_kg_m2;
};

/* A finger whose weight is compensated. Its chain's first joints move, the others are held. */
struct twd_finger_setup {
    const struct twd_chain *chain;
    /* 1..chain->joints */
    uint8_t moving;
    /* [moving]: index into the controller's joints. */
    uint8_t joint[TWD_MAX_CHAIN_JOINTS];
    /* [chain->joints - moving] */
    twd_num held_rad[TWD_MAX_CHAIN_JOINTS];
};

/* A controller: const, in flash. Pointers refer to arrays as long as the counts say. */
struct twd_setup {
    const struct twd_model *model;
    struct twd_cpg_config oscillators;
    enum twd_phase_start phase_start;
    enum twd_saturation saturation;
    struct twd_parameter_ranges ranges;
    /* Of twd_controller_torque, (0, 0.1] s; counts where a joint has an inertia. */
    twd_small torque_period_s;
    /* 1..TWD_MAX_JOINTS */
    uint8_t joints;
    /* [joints] */
    const struct twd_joint_range *range;
    /* [joints] */
    const struct twd_joint_setup *joint;
    /* 0..TWD_MAX_CHAINS; 0: no gravity compensation. */
    uint8_t fingers;
    /* [fingers] */
    const struct twd_finger_setup *finger;
    /* 0..20 */
    twd_wide gravity_m_s2;
    /* Unit vector in the chains' base frame. */
    twd_num gravity_direction[3];
};

/* Write the configuration that `setup` asks for. Errors: a null table, too many joints or fingers, what twd_pd_stable
 * and twd_gravity_init refuse; `config` is then not to be used. The rest is checked by twd_controller_init. */
enum twd_error twd_setup_config(const struct twd_setup *setup, struct twd_controller_config *config);

TWD_END_DECLARATIONS

#endif
