/* What one number build computes (accuracy.h). */
#include "accuracy.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <twiddle/controller.h>
#include <twiddle/convert.h>
#include <twiddle/elementary.h>
#include <twiddle/icub_right_hand.h>
#include <twiddle/input_map.h>
#include <twiddle/learner.h>
#include <twiddle/phase.h>

/* Numerical Recipes' 64-bit linear congruential generator: a whole number of 0..2^bits - 1. */
static uint32_t draw(unsigned bits)
{
    static uint64_t state = 20110824U;
    state = state * 6364136223846793005U + 1442695040888963407U;
    return (uint32_t)(state >> (64U - bits));
}

static void write_double(double value)
{
    if (fwrite(&value, sizeof value, 1, stdout) != 1) {
        perror("record_accuracy: cannot write to standard output");
        exit(1);
    }
}

static void require(enum twd_error error)
{
    if (error == TWD_OK) return;
    fprintf(stderr, "record_accuracy: %s\n", twd_error_text(error));
    exit(1);
}

/* A finger whose first two joints are `first` and `second`, with the others straight and gravity along the palm. */
static void set_finger(struct twd_finger *finger, const struct twd_chain *chain, enum twd_icub_joint first,
                       enum twd_icub_joint second)
{
    static const twd_num held_rad[2] = {TWD_NUM(0), TWD_NUM(0)};
    static const twd_num direction[3] = {TWD_NUM(-1), TWD_NUM(0), TWD_NUM(0)};
    finger->joint[0] = (uint8_t)first;
    finger->joint[1] = (uint8_t)second;
    require(twd_gravity_init(&finger->gravity, chain, 2, held_rad, TWD_WIDE(9.8125), direction));
}

/* Filter rates from 4 to 68 1/s, around the set-ups' 20. */
static twd_rate draw_rate(void)
{
    return twd_rate_from_double(4.0 + (double)draw(16) / 1024.0);
}

/* The iCub hand under CPG-H, with the widest frequency range of experiments/setups. The phases start at 0, so that the
 * couplings pull through the whole trial. */
static struct twd_controller_config draw_config(bool with_centre, double tick_s)
{
    struct twd_controller_config config;
    memset(&config, 0, sizeof config);
    config.model = &twd_model_h;
    config.oscillators.with_centre = with_centre;
    config.oscillators.tick_s = twd_small_from_double(tick_s);
    config.oscillators.amplitude_rate_per_s = draw_rate();
    config.oscillators.centre_rate_per_s = draw_rate();
    config.phase_start = TWD_PHASE_START_AT_ZERO;
    config.ranges.frequency_lower_hz = TWD_NUM(0.25);
    config.ranges.frequency_upper_hz = TWD_NUM(2);
    config.ranges.lone_frequency_hz = TWD_NUM(1);
    config.ranges.amplitude_upper = TWD_NUM(0.5);
    config.ranges.centre_lower = TWD_NUM(0);
    config.ranges.centre_upper = TWD_NUM(1);
    config.joints = ACCURACY_JOINTS;
    for (size_t j = 0; j < ACCURACY_JOINTS; j++) {
        config.joint[j].range = twd_icub_joint_range[j];
        config.joint[j].pd = (struct twd_pd){TWD_NUM(0.3125), TWD_NUM(0.0078125), TWD_NUM(1)};
    }
    config.fingers = 2;
    set_finger(&config.finger[0], &twd_icub_index, TWD_ICUB_AAI, TWD_ICUB_FEI);
    set_finger(&config.finger[1], &twd_icub_thumb, TWD_ICUB_OT, TWD_ICUB_FET);
    return config;
}

static void write_oscillator_outputs(const struct twd_cpg *cpg)
{
    for (int i = 0; i < ACCURACY_OSCILLATORS; i++)
        write_double(twd_num_to_double(twd_cpg_output(cpg, (uint8_t)i)));
}

/* In turns. */
static void write_phases(const struct twd_cpg *cpg)
{
    for (size_t i = 0; i < ACCURACY_OSCILLATORS; i++)
        write_double((double)cpg->oscillator[i].phase / 4294967296.0);
}

/* The desired angles, of the joints' ranges. */
static void write_joint_outputs(const twd_num *angle_rad)
{
    for (size_t j = 0; j < ACCURACY_JOINTS; j++) {
        const double lower_rad = twd_num_to_double(twd_icub_joint_range[j].lower_rad);
        const double upper_rad = twd_num_to_double(twd_icub_joint_range[j].upper_rad);
        write_double((twd_num_to_double(angle_rad[j]) - lower_rad) / (upper_rad - lower_rad));
    }
}

/* The torques at made-up angles of +-2 rad and velocities of +-16 rad/s. */
static void write_torques(struct twd_controller *controller, const twd_num *desired_rad)
{
    twd_num angle_rad[ACCURACY_JOINTS];
    twd_rate velocity_rad_s[ACCURACY_JOINTS];
    twd_num torque_nm[ACCURACY_JOINTS];
    for (size_t j = 0; j < ACCURACY_JOINTS; j++) {
        angle_rad[j] = twd_num_from_double((double)draw(20) / 262144.0 - 2.0);
        velocity_rad_s[j] = twd_rate_from_double((double)draw(20) / 32768.0 - 16.0);
    }
    twd_controller_torque(controller, desired_rad, angle_rad, velocity_rad_s, torque_nm);
    for (size_t j = 0; j < ACCURACY_JOINTS; j++)
        write_double(twd_num_to_double(torque_nm[j]));
}

static void record_trials(bool with_centre, double tick_s)
{
    for (int set = 0; set < ACCURACY_SETS; set++) {
        const struct twd_controller_config config = draw_config(with_centre, tick_s);
        const size_t parameters = twd_model_parameters(config.model, with_centre);
        struct twd_controller controller;
        twd_num parameter[TWD_MAX_UNITS];
        require(twd_controller_init(&controller, &config));
        /* Above 0, so that the selector's activations are, too. */
        for (size_t i = 0; i < parameters; i++)
            parameter[i] = twd_num_from_double((double)(draw(23) + 1U) / 8388608.0);
        require(twd_controller_start(&controller, parameter, parameters));
        for (int tick = 0; tick < ACCURACY_TICKS; tick++) {
            twd_num desired_rad[ACCURACY_JOINTS];
            twd_controller_tick(&controller, desired_rad);
            write_oscillator_outputs(&controller.cpg);
            write_joint_outputs(desired_rad);
            write_torques(&controller, desired_rad);
            write_phases(&controller.cpg);
        }
    }
}

static void record_sigmoid(void)
{
    for (int step = -SIGMOID_STEPS; step <= SIGMOID_STEPS; step++) {
        const double argument = (double)step / (double)(1 << SIGMOID_BITS);
        write_double(twd_num_to_double(twd_sigmoid(twd_wide_from_double(argument))));
    }
}

static void record_sine(void)
{
    twd_phase phase = 0;
    for (int step = 0; step < SINE_STEPS; step++) {
        twd_num sine, cosine;
        twd_sine_cosine(phase, &sine, &cosine);
        write_double(twd_num_to_double(twd_sin(phase)));
        write_double(twd_num_to_double(sine));
        write_double(twd_num_to_double(cosine));
        phase += UINT32_C(2654435769);
    }
}

/* A reward of the size of the paper's rotations, at most 4 rad, where all parameters are at their targets, 0.2 and 0.8
 * in turns. */
static double reward(const twd_num *parameter, size_t units)
{
    double shortfall = 0;
    for (size_t j = 0; j < units; j++) {
        const double distance = twd_num_to_double(parameter[j]) - (j % 2 == 0 ? 0.2 : 0.8);
        shortfall += distance * distance;
    }
    return 4.0 * (1.0 - shortfall / (double)units);
}

/* Learn as the paper does, and write what came of it. */
static void record_learning(uint64_t seed)
{
    const struct twd_learner_config config = {
        .units = TWD_MAX_UNITS,
        .inputs = TWD_INPUTS,
        .actor_rate = TWD_NUM(0.1),
        .critic_rate = TWD_NUM(0.1),
        .weight_range = TWD_NUM(0.05),
        .clip = TWD_NUM(0.001),
        .noise = {.start = TWD_NUM(0.5),
                  .end = TWD_NUM(0.05),
                  .decay_fraction = TWD_NUM(0.6),
                  .trials = LEARNING_TRIALS},
        .seed = seed,
    };
    twd_num input[TWD_INPUTS];
    twd_num parameter[TWD_MAX_UNITS];
    struct twd_learner learner;
    double sum_of_last = 0;
    twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.028), TWD_WIDE(10), input);
    require(twd_learner_init(&learner, &config));
    for (int trial = 0; trial < LEARNING_TRIALS; trial++) {
        twd_learner_act(&learner, input, parameter);
        const double earned = reward(parameter, config.units);
        (void)twd_learner_learn(&learner, twd_wide_from_double(earned));
        if (trial >= LEARNING_TRIALS - LEARNING_LAST_TRIALS) sum_of_last += earned;
    }
    twd_learner_policy(&learner, input, parameter);
    write_double(reward(parameter, config.units));
    write_double(sum_of_last / LEARNING_LAST_TRIALS);
}

int main(int argc, char **argv)
{
    const char *const course = argc > 1 ? argv[1] : "";
    if (strcmp(course, "trials") == 0 && argc == 4) {
        record_trials(strcmp(argv[2], "1") == 0, strtod(argv[3], NULL) / 1000.0);
    } else if (strcmp(course, "sigmoid") == 0) {
        record_sigmoid();
    } else if (strcmp(course, "sine") == 0) {
        record_sine();
    } else if (strcmp(course, "learning") == 0) {
        for (uint64_t seed = 1; seed <= LEARNING_SEEDS; seed++)
            record_learning(seed);
    } else {
        fprintf(stderr, "usage: record_accuracy trials CENTRES TICK | sigmoid | sine | learning\n");
        return 2;
    }
    if (fflush(stdout) != 0) {
        perror("record_accuracy: cannot write to standard output");
        return 1;
    }
    return 0;
}
