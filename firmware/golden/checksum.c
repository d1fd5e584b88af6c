#include "checksum.h"

static void take_word(uint32_t *sum, uint32_t word)
{
    for (unsigned bits = 0; bits < 32; bits += 8) {
        *sum ^= (word >> bits) & 0xFFU;
        *sum *= UINT32_C(0x01000193);
    }
}

void checksum_words(uint32_t *sum, const uint32_t *word, size_t count)
{
    for (size_t i = 0; i < count; i++)
        take_word(sum, word[i]);
}

void checksum_numbers(uint32_t *sum, const int32_t *number, size_t count)
{
    for (size_t i = 0; i < count; i++)
        take_word(sum, (uint32_t)number[i]);
}

static void take_number(uint32_t *sum, int32_t number)
{
    take_word(sum, (uint32_t)number);
}

/* Cores keep factors in different ways: of the same word, but for its sign. */
static void take_factor(uint32_t *sum, twd_factor factor)
{
    const int32_t word = twd_factor_word(factor);
    take_number(sum, word < 0 ? -word : word);
}

static void take_filter_step(uint32_t *sum, const struct twd_filter_step *step)
{
    take_factor(sum, step->mixing);
    take_factor(sum, step->decrease);
}

static void take_filter(uint32_t *sum, const struct twd_filter *filter)
{
    take_number(sum, filter->value);
    take_number(sum, filter->lead);
}

static void take_cpg(uint32_t *sum, const struct twd_cpg *cpg)
{
    take_filter_step(sum, &cpg->amplitude_step);
    take_filter_step(sum, &cpg->centre_step);
    take_number(sum, cpg->turn_gain);
    take_word(sum, cpg->intrinsic_advance);
    for (uint8_t k = 0; k < cpg->couplings; k++)
        take_word(sum, cpg->coupling[k].lag_and_quarter);
    for (uint8_t i = 0; i < cpg->oscillators; i++) {
        const struct twd_oscillator *const oscillator = &cpg->oscillator[i];
        take_word(sum, oscillator->phase);
        take_filter(sum, &oscillator->amplitude);
        take_filter(sum, &oscillator->centre);
        take_number(sum, oscillator->amplitude_target);
        take_number(sum, oscillator->centre_target);
        take_number(sum, oscillator->pull);
        take_number(sum, oscillator->last_pull);
        take_number(sum, oscillator->output);
    }
}

static void take_joint(uint32_t *sum, const struct twd_joint *joint)
{
    take_number(sum, joint->range.lower_rad);
    take_number(sum, joint->range.upper_rad);
    take_number(sum, joint->pd.stiffness_nm_per_rad);
    take_number(sum, joint->pd.damping_nms_per_rad);
    take_number(sum, joint->pd.torque_limit_nm);
}

static void take_finger(uint32_t *sum, const struct twd_finger *finger)
{
    const struct twd_gravity *const gravity = &finger->gravity;
    checksum_numbers(sum, gravity->direction, 3);
    for (uint8_t i = 0; i < gravity->moving; i++) {
        for (int row = 0; row < 3; row++)
            checksum_numbers(sum, gravity->joint[i].rotation[row], 3);
        checksum_numbers(sum, gravity->joint[i].moment_nm, 3);
    }
    if (gravity->moving != 2) return;
    for (int row = 0; row < 3; row++)
        checksum_numbers(sum, gravity->pair_energy_j[row], 3);
}

void checksum_controller(uint32_t *sum, const struct twd_controller *controller)
{
    const struct twd_controller_config *const config = &controller->config;
    take_cpg(sum, &controller->cpg);
    checksum_numbers(sum, controller->weight, config->model->cpgs);
    for (uint8_t j = 0; j < config->joints; j++)
        take_joint(sum, &config->joint[j]);
    for (uint8_t f = 0; f < config->fingers; f++)
        take_finger(sum, &config->finger[f]);
    take_word(sum, controller->saturations.output);
    take_word(sum, controller->saturations.torque);
    take_word(sum, controller->saturations.input);
}

void checksum_learner(uint32_t *sum, const struct twd_learner *learner)
{
    const struct twd_actor *const actor = &learner->actor;
    checksum_words(sum, learner->random.state, 4);
    for (uint8_t j = 0; j < actor->units; j++)
        checksum_numbers(sum, actor->weight[j], actor->inputs);
    checksum_numbers(sum, actor->output, actor->units);
    checksum_numbers(sum, actor->explored, actor->units);
    checksum_numbers(sum, actor->learned_value, actor->units);
    checksum_numbers(sum, learner->critic.weight, learner->critic.inputs);
    checksum_numbers(sum, learner->input, learner->config.inputs);
    take_number(sum, learner->noise);
    take_number(sum, learner->value);
    take_word(sum, learner->trial);
}
