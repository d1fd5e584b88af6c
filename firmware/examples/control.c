/* control.c: the whole of twiddle on one chip. The learner proposes parameters, the controller moves a hand for a
 * trial, the learner learns from the reward; at the two rates of a real hand. `make firmware` measures this image.
 *
 * In the place of motors and sensors stands the simplest hand there is: joints of no mass in a thick fluid, which move
 * as far as they are pushed, and sensors that know angles only. The reward is the way that the index finger's flexion
 * covers. */
#include "board.h"
#include "icub_setup.h"

#include <twiddle/icub_right_hand.h>

enum { TRIALS = 3, TICKS = 300, SUBSTEPS = 5, JOINTS = TWD_ICUB_JOINTS };

/* Large, so not on the stack. */
static struct twd_learner learner;
static struct twd_controller controller;

/* Let `torque_nm` act for one substep of 2 ms. Returns how far the index flexed or stretched, rad. */
static twd_num move(twd_num *angle_rad, const twd_num *torque_nm)
{
    twd_num way_rad = TWD_NUM(0);
    for (size_t j = 0; j < JOINTS; j++) {
        const twd_num step_rad = twd_mul(torque_nm[j], TWD_NUM(0.1)); /* in the fluid, 0.1 rad a substep for 1 N m */
        angle_rad[j] += step_rad;
        if (j == TWD_ICUB_FEI) way_rad = step_rad;
    }
    return way_rad < TWD_NUM(0) ? -way_rad : way_rad;
}

/* Run the controller through one trial of 3 s, from the straight hand. Returns the reward. */
static twd_wide run_trial(void)
{
    static const twd_rate unmeasured[JOINTS] = {TWD_RATE(0)};
    twd_num angle_rad[JOINTS] = {TWD_NUM(0)};
    twd_wide reward = TWD_WIDE(0);
    for (int tick = 0; tick < TICKS; tick++) {
        twd_num desired_rad[JOINTS];
        twd_controller_tick(&controller, desired_rad);
        for (int substep = 0; substep < SUBSTEPS; substep++) {
            twd_num torque_nm[JOINTS];
            twd_controller_torque(&controller, desired_rad, angle_rad, unmeasured, torque_nm);
            reward = twd_wide_add(reward, twd_wide_of_num(move(angle_rad, torque_nm)));
        }
    }
    return reward;
}

static enum twd_error set_up(void)
{
    struct twd_controller_config controller_config;
    enum twd_error error = icub_controller_config(&controller_config);
    if (error == TWD_OK) error = twd_controller_init(&controller, &controller_config);
    const struct twd_learner_config learner_config = icub_learner_config(TRIALS, 1);
    if (error == TWD_OK) error = twd_learner_init(&learner, &learner_config);
    return error;
}

static enum twd_error train(void)
{
    twd_num input[TWD_INPUTS];
    icub_small_sphere(input);
    for (int trial = 0; trial < TRIALS; trial++) {
        twd_num parameter[ICUB_PARAMETERS];
        twd_learner_act(&learner, input, parameter);
        const enum twd_error error = twd_controller_start(&controller, parameter, ICUB_PARAMETERS);
        if (error != TWD_OK) return error;
        (void)twd_learner_learn(&learner, run_trial());
    }
    return TWD_OK;
}

int main(void)
{
    enum twd_error error = set_up();
    if (error == TWD_OK) error = train();
    board_write("control: ");
    board_write(error == TWD_OK ? "learned from 3 trials" : twd_error_text(error));
    board_write("\n");
    return error == TWD_OK ? BOARD_SUCCESS : BOARD_FAILURE;
}
