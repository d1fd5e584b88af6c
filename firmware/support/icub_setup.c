#include "icub_setup.h"

#include <twiddle/icub_right_hand.h>

/* The two distal joints of index and thumb: 0.957 and 13.1 deg. */
#define INDEX_DISTAL_RAD TWD_NUM(0.0167028)
#define THUMB_DISTAL_RAD TWD_NUM(0.2286381)

static const struct twd_pd joint_pd[TWD_ICUB_JOINTS] = {
    [TWD_ICUB_FEI] = {TWD_NUM(0.313), TWD_NUM(0.00842), TWD_NUM(1)},
    [TWD_ICUB_AAI] = {TWD_NUM(0.476), TWD_NUM(0.0131), TWD_NUM(1)},
    [TWD_ICUB_FET] = {TWD_NUM(0.313), TWD_NUM(0.00842), TWD_NUM(1)},
    [TWD_ICUB_OT] = {TWD_NUM(0.551), TWD_NUM(0.0149), TWD_NUM(1)},
};

/* A finger whose first two joints are `first` and `second` and whose two others are held at `distal_rad`. */
static enum twd_error set_finger(struct twd_finger *finger, const struct twd_chain *chain, enum twd_icub_joint first,
                                 enum twd_icub_joint second, twd_num distal_rad)
{
    static const twd_num gravity_direction[3] = {TWD_NUM(-0.9659258), TWD_NUM(0), TWD_NUM(0.2588190)};
    const twd_num held_rad[2] = {distal_rad, distal_rad};
    finger->joint[0] = (uint8_t)first;
    finger->joint[1] = (uint8_t)second;
    return twd_gravity_init(&finger->gravity, chain, 2, held_rad, TWD_WIDE(9.81), gravity_direction);
}

enum twd_error icub_controller_config(struct twd_controller_config *config)
{
    *config = (struct twd_controller_config){
        .model = &twd_model_h,
        .oscillators = {.with_centre = true,
                        .tick_s = TWD_SMALL(0.01),
                        .amplitude_rate_per_s = TWD_RATE(20),
                        .centre_rate_per_s = TWD_RATE(20)},
        .ranges = {.frequency_lower_hz = TWD_NUM(0.233),
                   .frequency_upper_hz = TWD_NUM(1.11),
                   .lone_frequency_hz = TWD_NUM(0.948),
                   .amplitude_upper = TWD_NUM(0.5),
                   .centre_lower = TWD_NUM(0),
                   .centre_upper = TWD_NUM(1)},
        .joints = TWD_ICUB_JOINTS,
        .fingers = 2,
    };
    for (size_t i = 0; i < TWD_ICUB_JOINTS; i++) {
        config->joint[i].range = twd_icub_joint_range[i];
        config->joint[i].pd = joint_pd[i];
    }
    const enum twd_error error =
        set_finger(&config->finger[0], &twd_icub_index, TWD_ICUB_AAI, TWD_ICUB_FEI, INDEX_DISTAL_RAD);
    if (error != TWD_OK) return error;
    return set_finger(&config->finger[1], &twd_icub_thumb, TWD_ICUB_OT, TWD_ICUB_FET, THUMB_DISTAL_RAD);
}

struct twd_learner_config icub_learner_config(uint32_t trials, uint64_t seed)
{
    const struct twd_learner_config config = {
        .units = ICUB_PARAMETERS,
        .inputs = TWD_INPUTS,
        .actor_rate = TWD_NUM(0.1),
        .critic_rate = TWD_NUM(0.1),
        .weight_range = TWD_NUM(0.05),
        .clip = TWD_NUM(0.001),
        .noise = {.start = TWD_NUM(0.5), .end = TWD_NUM(0.05), .decay_fraction = TWD_NUM(0.6), .trials = trials},
        .seed = seed,
    };
    return config;
}

void icub_small_sphere(twd_num *input)
{
    twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.028), TWD_WIDE(10), input);
}
