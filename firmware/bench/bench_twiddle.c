/* bench_twiddle.c: twiddle's own costs: the seven oscillators, the whole tick, the torques, a trial's start, acting and
 * learning. What is counted are calls of `seven_tick` and of the library's own functions. */
#include "board.h"
#include "icub_setup.h"
#include "seven.h"

#include <twiddle/convert.h>
#include <twiddle/icub_right_hand.h>

enum { TRIALS = 20 };

static struct twd_controller controller;
static struct twd_learner learner;

/* The iCub hand, with the ranges of drive.h. */
static enum twd_error set_up(void)
{
    struct twd_controller_config config;
    const enum twd_error error = icub_controller_config(&config);
    if (error != TWD_OK) return error;
    config.phase_start = TWD_PHASE_START_AT_ZERO;
    config.oscillators.tick_s = TWD_SMALL(DRIVE_TICK_S);
    config.oscillators.amplitude_rate_per_s = TWD_RATE(DRIVE_RATE_PER_S);
    config.oscillators.centre_rate_per_s = TWD_RATE(DRIVE_RATE_PER_S);
    config.ranges.frequency_lower_hz = TWD_NUM(DRIVE_FREQUENCY_LOWER_HZ);
    config.ranges.frequency_upper_hz = TWD_NUM(DRIVE_FREQUENCY_UPPER_HZ);
    config.ranges.amplitude_upper = TWD_NUM(DRIVE_AMPLITUDE_UPPER);
    config.ranges.centre_lower = TWD_NUM(0);
    config.ranges.centre_upper = TWD_NUM(1);
    return twd_controller_init(&controller, &config);
}

static void start(const double *parameter)
{
    twd_num number[DRIVE_PARAMETERS];
    for (size_t i = 0; i < DRIVE_PARAMETERS; i++)
        number[i] = twd_num_from_double(parameter[i]);
    (void)twd_controller_start(&controller, number, DRIVE_PARAMETERS);
}

void seven_start(const double *parameter, const struct drive *drive)
{
    (void)drive;
    start(parameter);
}

/* The outputs come with the tick. */
void seven_tick(void)
{
    twd_cpg_tick(&controller.cpg);
}

double seven_output(size_t index)
{
    return twd_num_to_double(twd_cpg_output(&controller.cpg, (uint8_t)index));
}

/* The same sets as seven_run's, through the whole controller; the hand follows one tick behind. */
static void run_controller(void)
{
    static const twd_rate velocity_rad_s[TWD_ICUB_JOINTS] = {TWD_RATE(1), TWD_RATE(-0.5), TWD_RATE(2), TWD_RATE(-3)};
    twd_num angle_rad[TWD_ICUB_JOINTS] = {TWD_NUM(0)};
    for (unsigned set = 0; set < DRIVE_SETS; set++) {
        double parameter[DRIVE_PARAMETERS];
        drive_draw(set, parameter);
        start(parameter);
        for (int tick = 0; tick < DRIVE_TICKS; tick++) {
            twd_num desired_rad[TWD_ICUB_JOINTS];
            twd_num torque_nm[TWD_ICUB_JOINTS];
            twd_controller_tick(&controller, desired_rad);
            twd_controller_torque(&controller, desired_rad, angle_rad, velocity_rad_s, torque_nm);
            for (size_t j = 0; j < TWD_ICUB_JOINTS; j++)
                angle_rad[j] = desired_rad[j];
        }
    }
}

/* A training whose reward is the first parameter. */
static enum twd_error run_learner(void)
{
    const struct twd_learner_config config = icub_learner_config(TRIALS, 1);
    const enum twd_error error = twd_learner_init(&learner, &config);
    if (error != TWD_OK) return error;
    twd_num input[TWD_INPUTS];
    icub_small_sphere(input);
    for (int trial = 0; trial < TRIALS; trial++) {
        twd_num parameter[ICUB_PARAMETERS];
        twd_learner_act(&learner, input, parameter);
        (void)twd_learner_learn(&learner, twd_wide_of_num(parameter[0]));
    }
    return TWD_OK;
}

int main(void)
{
    enum twd_error error = set_up();
    if (error == TWD_OK) {
        seven_run();
        run_controller();
        error = run_learner();
    }
    if (error == TWD_OK) return BOARD_SUCCESS;
    board_write(twd_error_text(error));
    board_write("\n");
    return BOARD_FAILURE;
}
