/* controller.h: the whole controller, from a parameter vector to joint torques, at two rates.
 *
 *     at a trial's start   twd_controller_start    parameters in (0, 1) -> physical CPG parameters
 *     every tick (10 ms)   twd_controller_tick     CPGs -> gate -> joint ranges -> desired angles
 *     every substep        twd_controller_torque   gravity + PD -> torques
 *
 * The tick and the torque call cannot fail, allocate or block; both may be called from an interrupt, and torque may
 * interrupt tick, since it reads only what the caller passes. A value out of range is saturated and counted. */
#ifndef TWIDDLE_CONTROLLER_H
#define TWIDDLE_CONTROLLER_H

#include <twiddle/cpg.h>
#include <twiddle/detail/controller_names.h>
#include <twiddle/detail/four.h>
#include <twiddle/error.h>
#include <twiddle/gate.h>
#include <twiddle/gravity.h>
#include <twiddle/joint_range.h>
#include <twiddle/limits.h>
#include <twiddle/model.h>
#include <twiddle/pd.h>

TWD_BEGIN_DECLARATIONS

/* One driven joint. */
struct twd_joint {
    struct twd_joint_range range;
    struct twd_pd pd;
};

/* A finger whose weight is compensated, and which of the controller's joints its moving joints are. */
struct twd_finger {
    struct twd_gravity gravity;
    /* [gravity.moving]: index into the controller's joints. */
    uint8_t joint[TWD_MAX_CHAIN_JOINTS];
};

/* Where the oscillators' phases start a trial. */
enum twd_phase_start {
    /* Each at its desired lag (twd_cpg_phases_at_lag). */
    TWD_PHASE_START_AT_LAG = 0,
    /* All at 0; the couplings then pull them to their lags. */
    TWD_PHASE_START_AT_ZERO = 1
};

/* Where the joint outputs are saturated to [0, 1]; the paper does not say. The two differ where CPGs are mixed. */
enum twd_saturation {
    /* The weighted sum of the CPGs' outputs, as it is remapped. */
    TWD_SATURATE_SUM = 0,
    /* Each CPG's output, before it is weighted. */
    TWD_SATURATE_EACH = 1
};

/* All that a controller needs to know. Copied by init, except for the const tables behind its pointers. */
struct twd_controller_config {
    const struct twd_model *model;
    /* Of all CPGs; the paper's tick is 0.01 s. */
    struct twd_cpg_config oscillators;
    enum twd_phase_start phase_start;
    enum twd_saturation saturation;
    struct twd_parameter_ranges ranges;
    /* As many as the model's topologies drive. */
    uint8_t joints;
    struct twd_joint joint[TWD_MAX_JOINTS];
    /* 0: no gravity compensation. */
    uint8_t fingers;
    struct twd_finger finger[TWD_MAX_CHAINS];
};

/* How often a value was saturated since init. Counters stop at their maximum. */
struct twd_saturations {
    /* Outputs saturated to [0, 1]: of the joints, or of each CPG's oscillators (enum twd_saturation). */
    uint32_t output;
    /* Torques beyond the limit. */
    uint32_t torque;
    /* Joints given an angle or velocity that was not a number, or beyond 1e6 (float, double) or at the ends of its
     * type (fixed); they got zero torque. */
    uint32_t input;
};

/* A running controller. Fields may be read. */
struct twd_controller {
    struct twd_controller_config config;
    /* All CPGs of the model. */
    struct twd_cpg cpg;
    /* The selector's s_k of this trial. */
    twd_num weight[TWD_MAX_CPGS];
    struct twd_saturations saturations;
#if TWD_FOUR_AT_ONCE
    struct twd_four_joints four;
#endif
};

/* Prepare `controller`. `config` may be the controller's own, filled in place. Errors name what does not hold together
 * in `config`. */
enum twd_error twd_controller_init(struct twd_controller *controller, const struct twd_controller_config *config);

/* Start a trial with `count` parameters in [0, 1] (order: model.h). On an error the controller is as it was. */
enum twd_error twd_controller_start(struct twd_controller *controller, const twd_num *parameter, size_t count);

/* Advance the CPGs by one tick and write the desired angles, [joints], rad. */
void twd_controller_tick(struct twd_controller *controller, twd_num *desired_angle_rad);

/* Write the torques, [joints], N m, for the given desired and actual angles (rad) and velocities (rad/s), all
 * [joints]. */
void twd_controller_torque(struct twd_controller *controller, const twd_num *desired_angle_rad,
                           const twd_num *angle_rad, const twd_rate *velocity_rad_s, twd_num *torque_nm);

TWD_END_DECLARATIONS

#endif
