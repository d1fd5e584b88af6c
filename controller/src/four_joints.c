#include "four_joints.h"

#include <twiddle/phase.h>

#if TWD_FOUR_JOINTS

#define FOUR(value)                                                                                                    \
    {                                                                                                                  \
        {                                                                                                              \
            value, value, value, value                                                                                 \
        }                                                                                                              \
    }

const struct twd_four_constants twd_four_constants = {
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

void twd_four_joints_make(struct twd_four_joints *four, const struct twd_controller_config *config)
{
    four->fit = fits(config);
    if (!four->fit) return;

    for (uint8_t j = 0; j < 4; j++) {
        const struct twd_pd *const pd = &config->joint[j].pd;
        four->stiffness_nm_per_rad.of[j] = pd->stiffness_nm_per_rad;
        four->damping_nms_per_rad.of[j] = pd->damping_nms_per_rad;
        four->lower_limit_nm.of[j] = -pd->torque_limit_nm;
        four->upper_limit_nm.of[j] = pd->torque_limit_nm;
    }
    /* The slopes of each pair's energy: cos' = -sin, sin' = cos. */
    for (uint8_t f = 0; f < 2; f++) {
        const struct twd_finger *const finger = &config->finger[f];
        for (uint8_t k = 0; k < 3; k++) {
            const twd_num(*const energy_j)[3] = finger->gravity.pair_energy_j;
            four->gravity_nm[k].of[finger->joint[0]] = energy_j[2][k];
            four->gravity_nm[k].of[finger->joint[1]] = energy_j[k][2];
            four->gravity_nm[k + 3].of[finger->joint[0]] = energy_j[1][k];
            four->gravity_nm[k + 3].of[finger->joint[1]] = energy_j[k][1];
        }
    }
}

#else
/* ISO C wants a declaration in every file. */
typedef twd_num twd_four_joints_are_computed_one_by_one;
#endif
