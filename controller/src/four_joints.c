#include "four_joints.h"

#if TWD_FOUR_AT_ONCE

#define FOUR(value)                                                                                                    \
    {                                                                                                                  \
        {                                                                                                              \
            value, value, value, value                                                                                 \
        }                                                                                                              \
    }

const struct twd_four_constants twd_four_constants = {
    .sine = {FOUR(TWD_SINE_4), FOUR(TWD_SINE_3), FOUR(TWD_SINE_2), FOUR(TWD_SINE_1), FOUR(TWD_SINE_0)},
    .twice_half_sine = {FOUR(TWD_TWICE_HALF_SINE_4), FOUR(TWD_TWICE_HALF_SINE_3), FOUR(TWD_TWICE_HALF_SINE_2),
                        FOUR(TWD_TWICE_HALF_SINE_1), FOUR(TWD_TWICE_HALF_SINE_0)},
    .half_cosine = {FOUR(TWD_HALF_COSINE_4), FOUR(TWD_HALF_COSINE_3), FOUR(TWD_HALF_COSINE_2), FOUR(TWD_HALF_COSINE_1),
                    FOUR(TWD_HALF_COSINE_0)},
    .half = FOUR(TWD_NUM(0.5)),
    .one = FOUR(TWD_NUM(1)),
    .largest_angle_square = FOUR(TWD_NUM(9.8696)),
    .largest_square_sum = FOUR(TWD_NUM(1e12)),
};

/* Whether the two joints of `finger` are `first` and the next one. */
static bool has_joints(const struct twd_finger *finger, uint8_t first)
{
    if (finger->gravity.moving != 2) return false;
    return (finger->joint[0] == first && finger->joint[1] == first + 1) ||
           (finger->joint[1] == first && finger->joint[0] == first + 1);
}

static bool fits(const struct twd_controller_config *config)
{
    if (config->joints != 4 || config->fingers != 2) return false;
    const struct twd_finger *const finger = config->finger;
    return (has_joints(&finger[0], 0) && has_joints(&finger[1], 2)) ||
           (has_joints(&finger[0], 2) && has_joints(&finger[1], 0));
}

/* The slopes of a pair's energy: cos' = -sin, sin' = cos. */
static void set_gravity(struct twd_four_joints *four, const struct twd_finger *finger)
{
    const twd_num(*const energy_j)[3] = finger->gravity.pair_energy_j;
    const uint8_t first = finger->joint[0], second = finger->joint[1];
    for (uint8_t k = 0; k < 3; k++) {
        four->gravity_nm[k].of[first] = energy_j[2][k];
        four->gravity_nm[k].of[second] = energy_j[k][2];
        four->gravity_nm[k + 3].of[first] = energy_j[1][k];
        four->gravity_nm[k + 3].of[second] = energy_j[k][1];
    }
}

void twd_four_joints_make(struct twd_four_joints *four, const struct twd_controller_config *config)
{
    four->fit = fits(config);
    if (!four->fit) return;

    for (uint8_t j = 0; j < 4; j++) {
        const struct twd_joint *const joint = &config->joint[j];
        four->lower_rad.of[j] = joint->range.lower_rad;
        four->upper_rad.of[j] = joint->range.upper_rad;
        four->upper_less_lower_rad.of[j] = joint->range.upper_rad - joint->range.lower_rad;
        four->stiffness_nm_per_rad.of[j] = joint->pd.stiffness_nm_per_rad;
        four->damping_nms_per_rad.of[j] = joint->pd.damping_nms_per_rad;
        four->lower_limit_nm.of[j] = -joint->pd.torque_limit_nm;
        four->upper_limit_nm.of[j] = joint->pd.torque_limit_nm;
    }
    set_gravity(four, &config->finger[0]);
    set_gravity(four, &config->finger[1]);
}

void twd_four_joints_weigh(struct twd_four_joints *four, const struct twd_model *model, const twd_num *weight)
{
    if (!four->fit) return;

    struct twd_four *of_oscillator = four->weight;
    for (uint8_t k = 0; k < model->cpgs; k++) {
        const struct twd_topology *const topology = model->topology[k];
        for (uint8_t i = 0; i < topology->oscillators; i++, of_oscillator++)
            for (uint8_t j = 0; j < 4; j++)
                of_oscillator->of[j] = topology->joint_oscillator[j] == i ? weight[k] : TWD_NUM(0);
    }
}

#else
/* ISO C wants a declaration in every file. */
typedef twd_num twd_joints_are_computed_one_by_one;
#endif
