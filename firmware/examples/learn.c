/* learn.c: a chip that goes on learning where a training stopped. The header beside this file is what `twiddle export`
 * made of that training (`make example-policy`).
 *
 * What is learned here is not to turn an object but to please a formula, so that the example needs no hand: the nearer
 * all parameters are to the middle of their ranges, the better. run_trial is the place for the real thing. */
#include "board.h"
#include "example_policy.h"
#include "report.h"

enum { TRIALS = 500, UNITS = TWD_MAX_UNITS };

/* All memory that a learner needs. Static, since it takes 3 KiB. */
static struct twd_learner learner;

/* For the report. */
static uint32_t parameter_sum = REPORT_CHECKSUM_START;

/* On a real hand: twd_controller_start with the parameters, the loop of play.c for example_skill.trial_ticks ticks, and
 * as the reward what the movement was good for: in the training, example_reward_per_rad for a rotation of 1 rad. */
static twd_wide run_trial(const twd_num *parameter)
{
    twd_wide reward = TWD_WIDE(4);
    for (size_t i = 0; i < learner.config.units; i++) {
        const twd_num distance = parameter[i] - TWD_NUM(0.5);
        reward = twd_wide_subtract(reward, twd_wide_product(distance, distance));
    }
    return reward;
}

/* The reward of what has been learned, without noise. */
static twd_num reward_of_policy(void)
{
    twd_num parameter[UNITS];
    twd_learner_policy(&learner, example_learner.input, parameter);
    return twd_num_of_wide(run_trial(parameter));
}

static void learn(void)
{
    for (int trial = 0; trial < TRIALS; trial++) {
        twd_num parameter[UNITS];
        twd_learner_act(&learner, example_learner.input, parameter);
        (void)twd_learner_learn(&learner, run_trial(parameter));
        parameter_sum = report_checksum_of(parameter_sum, parameter, learner.config.units);
    }
}

int main(void)
{
    const enum twd_error error = twd_learner_restore(&learner, &example_learner);
    if (error != TWD_OK) {
        board_write(twd_error_text(error));
        return BOARD_FAILURE;
    }
    const twd_num before = reward_of_policy();
    report_count("learn: trials before ", learner.trial);
    learn();
    const twd_num after = reward_of_policy();
    report_count("trials now ", learner.trial);
    report_numbers("reward before:", &before, 1);
    report_numbers("reward now:", &after, 1);
    report_checksum("checksum of explored parameters ", parameter_sum);
    return after > before ? BOARD_SUCCESS : BOARD_FAILURE;
}
