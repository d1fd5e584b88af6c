/* A user's program: a CPG of its own through the whole controller, and a draw of the learner's generator. It compiles
 * as C and as C++. Exit status 0 if the outputs are what the equations say. */
#include <twiddle/controller.h>
#include <twiddle/convert.h>
#include <twiddle/random.h>

#include <stdio.h>
#include <string.h>

static const struct twd_coupling coupling[] = {{0, 1}};
static const uint8_t joint_oscillator[] = {0, 1};
static const twd_num initial_centre[] = {TWD_NUM(0.5), TWD_NUM(0.5)};
static const struct twd_topology wings = {"wings", 2, 1, 2, true, coupling, joint_oscillator, initial_centre};
static const struct twd_model model = {"wings", 1, {&wings}};

static struct twd_controller_config config_of_wings(void)
{
    struct twd_controller_config config;
    memset(&config, 0, sizeof config);
    config.model = &model;
    config.oscillators.with_centre = true;
    config.oscillators.tick_s = TWD_SMALL(0.01);
    config.oscillators.amplitude_rate_per_s = TWD_RATE(20);
    config.oscillators.centre_rate_per_s = TWD_RATE(20);
    config.ranges.frequency_lower_hz = TWD_NUM(0.5);
    config.ranges.frequency_upper_hz = TWD_NUM(1.5);
    config.ranges.lone_frequency_hz = TWD_NUM(1);
    config.ranges.amplitude_upper = TWD_NUM(0.5);
    config.ranges.centre_upper = TWD_NUM(1);
    config.joints = 2;
    for (int j = 0; j < 2; j++) {
        config.joint[j].range.lower_rad = TWD_NUM(-1);
        config.joint[j].range.upper_rad = TWD_NUM(1);
        config.joint[j].pd.stiffness_nm_per_rad = TWD_NUM(0.2);
        config.joint[j].pd.torque_limit_nm = TWD_NUM(1);
    }
    return config;
}

/* Whether `value` is within 1e-4 of `expected`. */
static bool close_to(twd_num value, twd_num expected)
{
    return twd_within(value - expected, TWD_NUM(-1e-4), TWD_NUM(1e-4));
}

int main(void)
{
    /* nu = 1 Hz, R = 0.5, C = 0.5, the second half a turn ahead: after 3 s, 1 and 0 of the range, which is 1 and -1
     * rad. */
    const twd_num parameter[] = {TWD_NUM(0.5), TWD_NUM(1), TWD_NUM(1), TWD_NUM(0.5), TWD_NUM(0.5), TWD_NUM(0.5)};
    const struct twd_controller_config config = config_of_wings();
    struct twd_controller controller;
    enum twd_error error = twd_controller_init(&controller, &config);
    if (error == TWD_OK) error = twd_controller_start(&controller, parameter, sizeof parameter / sizeof *parameter);
    if (error != TWD_OK) {
        fprintf(stderr, "consumer: %s\n", twd_error_text(error));
        return 1;
    }

    twd_num desired_rad[2] = {TWD_NUM(0), TWD_NUM(0)};
    for (int tick = 0; tick < 300; tick++)
        twd_controller_tick(&controller, desired_rad);

    struct twd_random random;
    twd_random_seed(&random, 1);
    const bool drawn = twd_within(twd_random_symmetric(&random, TWD_NUM(0.5)), TWD_NUM(-0.5), TWD_NUM(0.5));

    printf("%s: %f %f\n", TWD_NUMBER_NAME, twd_num_to_double(desired_rad[0]), twd_num_to_double(desired_rad[1]));
    return close_to(desired_rad[0], TWD_NUM(1)) && close_to(desired_rad[1], TWD_NUM(-1)) && drawn ? 0 : 1;
}
