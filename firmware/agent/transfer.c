#include "agent/transfer.h"

#include <string.h>

#define WORD 4U

/* The longest messages must fit, whatever sizes the library was built with. */
#if TWD_MAX_INPUTS > 66 || TWD_MAX_UNITS > 66 || TWD_MAX_JOINTS > 32 || TWD_MAX_CHAIN_JOINTS > 4
#error "TWD_FRAME_MAX_PAYLOAD is too small for the sizes of the library"
#endif

const struct twd_model *twd_model_of_number(uint32_t number)
{
    static const struct twd_model *const models[TWD_MODELS] = {&twd_model_c, &twd_model_m, &twd_model_s, &twd_model_h};
    return number < TWD_MODELS ? models[number] : NULL;
}

static uint32_t number_of_model(const struct twd_model *model)
{
    uint32_t number = 0;
    while (number < TWD_MODELS && twd_model_of_number(number) != model)
        number++;
    return number;
}

struct twd_transfer twd_transfer_to(struct twd_frame *frame)
{
    const struct twd_transfer transfer = {frame, 0, true, false};
    frame->length = 0;
    return transfer;
}

struct twd_transfer twd_transfer_from(struct twd_frame *frame)
{
    const struct twd_transfer transfer = {frame, 0, false, false};
    return transfer;
}

bool twd_transfer_end(struct twd_transfer *transfer)
{
    if (transfer->writing) transfer->frame->length = transfer->at;
    return !transfer->failed && transfer->at == transfer->frame->length;
}

/* The next four bytes of the payload, or a null pointer at its end. */
static uint8_t *next_word(struct twd_transfer *transfer)
{
    const uint16_t limit = transfer->writing ? (uint16_t)TWD_FRAME_MAX_PAYLOAD : transfer->frame->length;
    if (transfer->failed || transfer->at + WORD > limit) {
        transfer->failed = true;
        return NULL;
    }
    uint8_t *const bytes = transfer->frame->payload + transfer->at;
    transfer->at = (uint16_t)(transfer->at + WORD);
    return bytes;
}

static void whole_number(struct twd_transfer *transfer, uint32_t *value)
{
    uint8_t *const bytes = next_word(transfer);
    if (bytes == NULL) return;
    if (transfer->writing) {
        for (unsigned i = 0; i < WORD; i++)
            bytes[i] = (uint8_t)(*value >> (8U * i));
        return;
    }
    *value = 0;
    for (unsigned i = 0; i < WORD; i++)
        *value |= (uint32_t)bytes[i] << (8U * i);
}

void twd_transfer_words(struct twd_transfer *transfer, void *words, size_t count)
{
    uint8_t *const object = words;
    for (size_t i = 0; i < count; i++) {
        uint32_t word = 0;
        if (transfer->writing) memcpy(&word, object + i * WORD, WORD);
        whole_number(transfer, &word);
        if (!transfer->writing) memcpy(object + i * WORD, &word, WORD);
    }
}

/* One of the library's numbers, of any of its types. */
static void number(struct twd_transfer *transfer, void *value)
{
    twd_transfer_words(transfer, value, 1);
}

/* A whole number in 0..`most`; reads 0 for one beyond. */
static uint32_t small_number(struct twd_transfer *transfer, uint32_t value, uint32_t most)
{
    whole_number(transfer, &value);
    if (value <= most) return value;
    transfer->failed = true;
    return 0;
}

static void byte(struct twd_transfer *transfer, uint8_t *value)
{
    *value = (uint8_t)small_number(transfer, *value, UINT8_MAX);
}

static void flag(struct twd_transfer *transfer, bool *value)
{
    *value = small_number(transfer, *value ? 1U : 0U, 1U) == 1U;
}

void twd_transfer_hello(struct twd_transfer *transfer, struct twd_hello *hello)
{
    whole_number(transfer, &hello->protocol);
    whole_number(transfer, &hello->numbers);
    whole_number(transfer, &hello->joints);
    whole_number(transfer, &hello->fingers);
    whole_number(transfer, &hello->units);
    whole_number(transfer, &hello->inputs);
}

static void model(struct twd_transfer *transfer, const struct twd_model **model)
{
    const uint32_t mine = transfer->writing ? number_of_model(*model) : 0U;
    *model = twd_model_of_number(small_number(transfer, mine, TWD_MODELS - 1U));
}

static void oscillators(struct twd_transfer *transfer, struct twd_cpg_config *config)
{
    flag(transfer, &config->with_centre);
    number(transfer, &config->tick_s);
    number(transfer, &config->amplitude_rate_per_s);
    number(transfer, &config->centre_rate_per_s);
    config->return_lag =
        (enum twd_return_lag)small_number(transfer, (uint32_t)config->return_lag, TWD_RETURN_LAG_EQUAL);
    config->centre_start =
        (enum twd_centre_start)small_number(transfer, (uint32_t)config->centre_start, TWD_CENTRE_START_AT_TARGET);
}

static void ranges(struct twd_transfer *transfer, struct twd_parameter_ranges *ranges)
{
    number(transfer, &ranges->frequency_lower_hz);
    number(transfer, &ranges->frequency_upper_hz);
    number(transfer, &ranges->lone_frequency_hz);
    number(transfer, &ranges->amplitude_upper);
    number(transfer, &ranges->centre_lower);
    number(transfer, &ranges->centre_upper);
}

void twd_transfer_controller(struct twd_transfer *transfer, struct twd_controller_config *config)
{
    model(transfer, &config->model);
    oscillators(transfer, &config->oscillators);
    config->phase_start =
        (enum twd_phase_start)small_number(transfer, (uint32_t)config->phase_start, TWD_PHASE_START_AT_ZERO);
    config->saturation = (enum twd_saturation)small_number(transfer, (uint32_t)config->saturation, TWD_SATURATE_EACH);
    ranges(transfer, &config->ranges);
    byte(transfer, &config->joints);
    byte(transfer, &config->fingers);
}

void twd_transfer_joint(struct twd_transfer *transfer, uint8_t *index, struct twd_joint *joint)
{
    byte(transfer, index);
    number(transfer, &joint->range.lower_rad);
    number(transfer, &joint->range.upper_rad);
    number(transfer, &joint->pd.stiffness_nm_per_rad);
    number(transfer, &joint->pd.damping_nms_per_rad);
    number(transfer, &joint->pd.torque_limit_nm);
}

void twd_transfer_finger(struct twd_transfer *transfer, uint8_t *index, struct twd_finger *finger)
{
    struct twd_gravity *const gravity = &finger->gravity;
    byte(transfer, index);
    gravity->moving = (uint8_t)small_number(transfer, gravity->moving, TWD_MAX_CHAIN_JOINTS);
    twd_transfer_words(transfer, gravity->direction, 3);
    for (unsigned i = 0; i < gravity->moving; i++) {
        byte(transfer, &finger->joint[i]);
        twd_transfer_words(transfer, gravity->joint[i].rotation, 9);
        twd_transfer_words(transfer, gravity->joint[i].moment_nm, 3);
    }
    twd_transfer_words(transfer, gravity->pair_energy_j, 9);
}

/* A size that the library counts in size_t, which is 16 bits wide on the smallest chips. */
static void size(struct twd_transfer *transfer, size_t *value)
{
    *value = (size_t)small_number(transfer, (uint32_t)*value, UINT16_MAX);
}

void twd_transfer_learner(struct twd_transfer *transfer, struct twd_learner_config *config)
{
    size(transfer, &config->units);
    size(transfer, &config->inputs);
    number(transfer, &config->actor_rate);
    number(transfer, &config->critic_rate);
    number(transfer, &config->weight_range);
    number(transfer, &config->clip);
    number(transfer, &config->noise.start);
    number(transfer, &config->noise.end);
    number(transfer, &config->noise.decay_fraction);
    whole_number(transfer, &config->noise.trials);
    size(transfer, &config->silent_units);
    config->learned_value =
        (enum twd_learned_value)small_number(transfer, (uint32_t)config->learned_value, TWD_LEARN_FROM_UNCLIPPED);
    uint32_t seed[2] = {(uint32_t)config->seed, (uint32_t)(config->seed >> 32)};
    twd_transfer_words(transfer, seed, 2);
    config->seed = (uint64_t)seed[1] << 32 | seed[0];
}

void twd_transfer_trial_start(struct twd_transfer *transfer, struct twd_trial_start *start, uint8_t cpgs)
{
    number(transfer, &start->value);
    number(transfer, &start->noise);
    twd_transfer_words(transfer, start->weight, cpgs);
}

void twd_transfer_state(struct twd_transfer *transfer, struct twd_agent_state *state)
{
    whole_number(transfer, &state->trials);
    twd_transfer_words(transfer, state->random.state, 4);
    whole_number(transfer, &state->saturations.output);
    whole_number(transfer, &state->saturations.torque);
    whole_number(transfer, &state->saturations.input);
}
