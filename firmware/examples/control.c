/* control.c: the whole of twiddle on one chip. The learner proposes parameters, the controller moves a hand for a trial, the
 * learner learns from the reward; at the two rates of a real hand. `make firmware` measures this image.
 *
 * In the place of motors and sensors stands the simplest hand there is: joints of no mass in a thick fluid, whose
 * speed is proportional to the torque. Its reward is the way that the index finger's flexion covers. */
#include "board.h"
#include "icub_setup.h"

#include <twiddle/icub_right_hand.h>

enum { TRIALS = 3, TICKS = 300, SUBSTEPS = 5, JOINTS = TWD_ICUB_JOINTS };

struct hand {
    twd_num angle_rad[JOINTS];
    twd_num velocity_rad_s[JOINTS];
};

/* Large, so not on the stack. */
static struct twd_agent agent;
static struct twd_controller controller;

/* Let `torque_nm` act for one substep of 2 ms. Returns how far the index flexed or stretched, rad. */
static twd_num move(struct hand *hand, const twd_num *torque_nm)
{
    for (size_t j = 0; j < JOINTS; j++) {
        hand->velocity_rad_s[j] = twd_mul(torque_nm[j], TWD_NUM(50)); /* rad/s for 1 N m */
        hand->angle_rad[j] += twd_mul(hand->velocity_rad_s[j], TWD_NUM(0.002));
    }
    const twd_num way = twd_mul(hand->velocity_rad_s[TWD_ICUB_FEI], TWD_NUM(0.002));
    return way < TWD_NUM(0) ? -way : way;
}

/* Run the controller through one trial of 3 s, from the straight hand. Returns the reward. */
static twd_num run_trial(void)
{
    struct hand hand = {{TWD_NUM(0)}, {TWD_NUM(0)}};
    twd_num reward = TWD_NUM(0);
    for (int tick = 0; tick < TICKS; tick++) {
        twd_num desired_rad[JOINTS];
        twd_controller_tick(&controller, desired_rad);
        for (int substep = 0; substep < SUBSTEPS; substep++) {
            twd_num torque_nm[JOINTS];
            twd_controller_torque(&controller, desired_rad, hand.angle_rad, hand.velocity_rad_s, torque_nm);
            reward += move(&hand, torque_nm);
        }
    }
    return reward;
}

static enum twd_error set_up(void)
{
    struct twd_controller_config controller_config;
    enum twd_error error = icub_controller_config(&controller_config);
    if (error == TWD_OK) error = twd_controller_init(&controller, &controller_config);
    const struct twd_agent_config agent_config = icub_agent_config(TRIALS, 1);
    if (error == TWD_OK) error = twd_agent_init(&agent, &agent_config);
    return error;
}

static enum twd_error train(void)
{
    twd_num input[TWD_INPUTS];
    icub_small_sphere(input);
    for (int trial = 0; trial < TRIALS; trial++) {
        twd_num parameter[ICUB_PARAMETERS];
        twd_agent_act(&agent, input, parameter);
        const enum twd_error error = twd_controller_start(&controller, parameter, ICUB_PARAMETERS);
        if (error != TWD_OK) return error;
        (void)twd_agent_learn(&agent, run_trial());
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
