/* controller_fixture.h: the controllers of the controller's tests: four joints, at 10 ms, with or without a finger. */
#ifndef TWIDDLE_CONTROLLER_FIXTURE_H
#define TWIDDLE_CONTROLLER_FIXTURE_H

#include "controller_test.h"

#include <twiddle/controller.h>

#define RATE_PER_S 20.0
#define TICK_S 0.01

/* The ranges of FEI, AAI, FET, OT, rad. */
static const double lower_rad[4] = {0.0, -0.25, 0.0, 0.0};
static const double upper_rad[4] = {1.5, 0.25, 1.5, 2.25};

static inline struct twd_controller_config config_of(const struct twd_model *model, bool with_centre)
{
    struct twd_controller_config config;
    memset(&config, 0, sizeof config);
    config.model = model;
    config.oscillators.with_centre = with_centre;
    config.oscillators.tick_s = TWD_SMALL(TICK_S);
    config.oscillators.amplitude_rate_per_s = TWD_RATE(RATE_PER_S);
    config.oscillators.centre_rate_per_s = TWD_RATE(RATE_PER_S);
    config.ranges.frequency_lower_hz = TWD_NUM(0.5);
    config.ranges.frequency_upper_hz = TWD_NUM(1.5);
    config.ranges.lone_frequency_hz = TWD_NUM(1);
    config.ranges.amplitude_upper = TWD_NUM(0.5);
    config.ranges.centre_upper = TWD_NUM(1);
    config.joints = 4;
    for (int j = 0; j < 4; j++) {
        config.joint[j].range.lower_rad = twd_num_from_double(lower_rad[j]);
        config.joint[j].range.upper_rad = twd_num_from_double(upper_rad[j]);
        config.joint[j].pd = (struct twd_pd){TWD_NUM(0.2), TWD_NUM(0.01), TWD_NUM(1)};
    }
    return config;
}

/* One link of 0.1 kg along x, 0.02 m to its centre of mass, turning about z. */
#define PENDULUM                                                                                                       \
    {                                                                                                                  \
        .rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},                                                             \
                     {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},                                                             \
                     {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},                                                            \
        .mass_kg = TWD_NUM(0.1), .centre_of_mass_m = {TWD_NUM(0.02), TWD_NUM(0), TWD_NUM(0)},                          \
    }

/* Give joint `joint` a pendulum as its finger; gravity along -y. */
static inline void add_pendulum(struct twd_controller_config *config, uint8_t joint)
{
    static const struct twd_chain_joint pendulum = PENDULUM;
    static const twd_num down[3] = {TWD_NUM(0), TWD_NUM(-1), TWD_NUM(0)};
    const struct twd_chain chain = {1, &pendulum};
    struct twd_finger *const finger = &config->finger[config->fingers++];
    assert_int_equal(twd_gravity_init(&finger->gravity, &chain, 1, NULL, TWD_WIDE(9.81), down), TWD_OK);
    finger->joint[0] = joint;
}

#endif
