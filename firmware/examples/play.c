/* play.c: a trained skill on a chip. The header beside this file is what `twiddle export` made of a training (`make
 * example-policy`); the two functions below are all that playing it takes.
 *
 * On a real hand a timer of 100 Hz calls twd_controller_tick, and one of 500 Hz calls torque_period with the board's
 * own encoders and motors; the movement goes on until they are stopped. Here they are called in turn, for 3 s. */
#include "board.h"
#include "example_policy.h"
#include "report.h"
#include "toy_hand.h"

enum { JOINTS = TWD_ICUB_JOINTS, TORQUES_A_TICK = 5 };

/* All memory that a skill needs. Static, since it takes 2 KiB. */
static struct twd_controller controller;
static twd_num desired_rad[JOINTS];

/* In the place of motors and encoders. */
static struct toy_hand hand;

/* For the report. */
static uint32_t desired_sum = REPORT_CHECKSUM_START;
static uint32_t torque_sum = REPORT_CHECKSUM_START;
static twd_num furthest_rad[JOINTS];

/* Every 2 ms: where the hand is, and what its motors are to do. */
static void torque_period(void)
{
    twd_num angle_rad[JOINTS], torque_nm[JOINTS];
    twd_rate velocity_rad_s[JOINTS];
    toy_hand_measure(&hand, angle_rad, velocity_rad_s);
    twd_controller_torque(&controller, desired_rad, angle_rad, velocity_rad_s, torque_nm);
    toy_hand_drive(&hand, torque_nm);
    torque_sum = report_checksum_of(torque_sum, torque_nm, JOINTS);
}

static void note_distance(void)
{
    for (size_t j = 0; j < JOINTS; j++) {
        const twd_num ahead_rad = desired_rad[j] - hand.angle_rad[j];
        const twd_num distance_rad = ahead_rad < TWD_NUM(0) ? -ahead_rad : ahead_rad;
        if (distance_rad > furthest_rad[j]) furthest_rad[j] = distance_rad;
    }
}

int main(void)
{
    const enum twd_error error = twd_skill_start(&example_skill, &controller);
    if (error != TWD_OK) {
        board_write(twd_error_text(error));
        return BOARD_FAILURE;
    }
    for (uint16_t tick = 0; tick < example_skill.trial_ticks; tick++) {
        twd_controller_tick(&controller, desired_rad);
        for (int i = 0; i < TORQUES_A_TICK; i++)
            torque_period();
        desired_sum = report_checksum_of(desired_sum, desired_rad, JOINTS);
        note_distance();
    }
    report_count("play: ticks ", example_skill.trial_ticks);
    report_numbers("angles at the end, rad:", hand.angle_rad, JOINTS);
    report_numbers("furthest from the desired, rad:", furthest_rad, JOINTS);
    report_count("saturated torques ", controller.saturations.torque);
    report_checksum("checksum of desired angles ", desired_sum);
    report_checksum("checksum of torques ", torque_sum);
    return BOARD_SUCCESS;
}
