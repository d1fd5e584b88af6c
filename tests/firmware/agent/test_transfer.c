/* Payloads: both directions of each say the same, and what is cut, too long or out of range is refused. */
#include "agent_test.h"

#include "agent/transfer.h"

/* Fill an object with random bytes. */
static void scribble(uint64_t *random, void *object, size_t size)
{
    uint8_t *const bytes = object;
    for (size_t i = 0; i < size; i++)
        bytes[i] = (uint8_t)random_below(random, 256);
}

/* Any configuration, made of random words; the fields with few values get one of them. */
static struct twd_controller_config random_controller(uint64_t *random)
{
    struct twd_controller_config config;
    scribble(random, &config, sizeof config);
    config.model = twd_model_of_number(random_below(random, TWD_MODELS));
    config.oscillators.with_centre = random_below(random, 2) == 1;
    config.oscillators.return_lag = (enum twd_return_lag)random_below(random, 2);
    config.oscillators.centre_start = (enum twd_centre_start)random_below(random, 3);
    config.phase_start = (enum twd_phase_start)random_below(random, 2);
    config.saturation = (enum twd_saturation)random_below(random, 2);
    for (int f = 0; f < TWD_MAX_CHAINS; f++)
        config.finger[f].gravity.moving = (uint8_t)random_below(random, TWD_MAX_CHAIN_JOINTS + 1);
    return config;
}

/* One message read from a frame into the object at `target`. */
typedef void (*reading)(struct twd_transfer *transfer, void *target);

/* The message in `frame` is read whole, and refused with one byte or word less or more. */
static void expect_exact_length(const struct twd_frame *frame, reading read, void *target)
{
    for (uint16_t length = 0; length <= TWD_FRAME_MAX_PAYLOAD; length++) {
        struct twd_frame other = *frame;
        other.length = length;
        struct twd_transfer transfer = twd_transfer_from(&other);
        read(&transfer, target);
        assert_int_equal(twd_transfer_end(&transfer), length == frame->length);
    }
}

/* A message that reads differently with a word's value at `word` is refused with it set to `value`. */
static void expect_refused(const struct twd_frame *frame, size_t word, uint32_t value, reading read, void *target)
{
    struct twd_frame other = *frame;
    for (unsigned i = 0; i < 4; i++)
        other.payload[4 * word + i] = (uint8_t)(value >> (8U * i));
    struct twd_transfer transfer = twd_transfer_from(&other);
    read(&transfer, target);
    assert_false(twd_transfer_end(&transfer));
}

static void read_controller(struct twd_transfer *transfer, void *target)
{
    twd_transfer_controller(transfer, target);
}

/* The controller's fields come back, each in its place. Expected: the fields that were sent. */
static void controller_comes_back(void **state)
{
    uint64_t random = 1;
    (void)state;
    for (int i = 0; i < 100; i++) {
        struct twd_controller_config sent = random_controller(&random);
        struct twd_controller_config got;
        memset(&got, 0, sizeof got);
        struct twd_frame frame;
        struct twd_transfer transfer = twd_transfer_to(&frame);
        twd_transfer_controller(&transfer, &sent);
        assert_true(twd_transfer_end(&transfer));
        expect_exact_length(&frame, read_controller, &got);
        transfer = twd_transfer_from(&frame);
        twd_transfer_controller(&transfer, &got);

        assert_ptr_equal(got.model, sent.model);
        assert_int_equal(got.oscillators.with_centre, sent.oscillators.with_centre);
        assert_memory_equal(&got.oscillators.tick_s, &sent.oscillators.tick_s, sizeof(twd_num));
        assert_memory_equal(&got.oscillators.amplitude_rate_per_s, &sent.oscillators.amplitude_rate_per_s, 4);
        assert_memory_equal(&got.oscillators.centre_rate_per_s, &sent.oscillators.centre_rate_per_s, 4);
        assert_int_equal(got.oscillators.return_lag, sent.oscillators.return_lag);
        assert_int_equal(got.oscillators.centre_start, sent.oscillators.centre_start);
        assert_int_equal(got.phase_start, sent.phase_start);
        assert_int_equal(got.saturation, sent.saturation);
        assert_memory_equal(&got.ranges, &sent.ranges, sizeof sent.ranges);
        assert_int_equal(got.joints, sent.joints);
        assert_int_equal(got.fingers, sent.fingers);
    }
}

/* A model, choice or count beyond those there are is refused. Expected: the words' places in docs/PROTOCOL.md. */
static void controller_out_of_range_is_refused(void **state)
{
    uint64_t random = 2;
    struct twd_controller_config sent = random_controller(&random);
    struct twd_controller_config got;
    struct twd_frame frame;
    struct twd_transfer transfer = twd_transfer_to(&frame);
    (void)state;
    twd_transfer_controller(&transfer, &sent);
    assert_true(twd_transfer_end(&transfer));
    static const struct {
        size_t word;
        uint32_t value;
    } cases[] = {{0, 4}, {0, 256}, {1, 2}, {5, 2}, {6, 3}, {7, 2}, {8, 2}, {8, 0x100}, {15, 256}, {16, 0xFFFFFFFFU}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        expect_refused(&frame, cases[i].word, cases[i].value, read_controller, &got);
}

/* A finger and its index, or a joint and its. */
struct placed_finger {
    uint8_t index;
    struct twd_finger finger;
};

static void read_finger(struct twd_transfer *transfer, void *target)
{
    struct placed_finger *const placed = target;
    twd_transfer_finger(transfer, &placed->index, &placed->finger);
}

/* A finger of any number of moving joints comes back, also the largest. Expected: the fields that were sent. */
static void finger_comes_back(void **state)
{
    uint64_t random = 3;
    (void)state;
    for (int i = 0; i < 100; i++) {
        struct placed_finger sent = {(uint8_t)random_below(&random, 256), random_controller(&random).finger[0]};
        struct placed_finger got;
        memset(&got, 0, sizeof got);
        struct twd_frame frame;
        struct twd_transfer transfer = twd_transfer_to(&frame);
        twd_transfer_finger(&transfer, &sent.index, &sent.finger);
        assert_true(twd_transfer_end(&transfer));
        expect_exact_length(&frame, read_finger, &got);
        expect_refused(&frame, 1, TWD_MAX_CHAIN_JOINTS + 1, read_finger, &got);
        transfer = twd_transfer_from(&frame);
        twd_transfer_finger(&transfer, &got.index, &got.finger);

        assert_int_equal(got.index, sent.index);
        const struct twd_gravity *const gravity = &got.finger.gravity;
        assert_int_equal(gravity->moving, sent.finger.gravity.moving);
        assert_memory_equal(gravity->direction, sent.finger.gravity.direction, sizeof gravity->direction);
        assert_memory_equal(got.finger.joint, sent.finger.joint, gravity->moving);
        assert_memory_equal(gravity->joint, sent.finger.gravity.joint, gravity->moving * sizeof gravity->joint[0]);
        assert_memory_equal(gravity->pair_energy_j, sent.finger.gravity.pair_energy_j, sizeof gravity->pair_energy_j);
    }
}

/* A joint comes back. Expected: the fields that were sent. */
static void joint_comes_back(void **state)
{
    uint64_t random = 4;
    uint8_t index = 7;
    uint8_t got_index = 0;
    struct twd_joint sent = random_controller(&random).joint[0];
    struct twd_joint got;
    struct twd_frame frame;
    struct twd_transfer transfer = twd_transfer_to(&frame);
    (void)state;
    twd_transfer_joint(&transfer, &index, &sent);
    assert_true(twd_transfer_end(&transfer));
    transfer = twd_transfer_from(&frame);
    twd_transfer_joint(&transfer, &got_index, &got);
    assert_true(twd_transfer_end(&transfer));
    assert_int_equal(got_index, 7);
    assert_memory_equal(&got, &sent, sizeof sent);
}

static void read_learner(struct twd_transfer *transfer, void *target)
{
    twd_transfer_learner(transfer, target);
}

/* The learner comes back, also a seed of 64 bits; sizes and choices beyond what they may be are refused. Expected: the
 * fields that were sent. */
static void learner_comes_back(void **state)
{
    uint64_t random = 5;
    struct twd_learner_config sent;
    struct twd_learner_config got;
    struct twd_frame frame;
    (void)state;
    scribble(&random, &sent, sizeof sent);
    memset(&got, 0, sizeof got);
    sent.units = 22;
    sent.inputs = 27;
    sent.silent_units = 3;
    sent.learned_value = TWD_LEARN_FROM_UNCLIPPED;
    struct twd_transfer transfer = twd_transfer_to(&frame);
    twd_transfer_learner(&transfer, &sent);
    assert_true(twd_transfer_end(&transfer));
    expect_exact_length(&frame, read_learner, &got);
    expect_refused(&frame, 0, 0x10000, read_learner, &got);
    expect_refused(&frame, 11, 2, read_learner, &got);
    transfer = twd_transfer_from(&frame);
    twd_transfer_learner(&transfer, &got);

    assert_int_equal(got.units, 22);
    assert_int_equal(got.inputs, 27);
    assert_memory_equal(&got.actor_rate, &sent.actor_rate, 4 * sizeof(twd_num));
    assert_memory_equal(&got.noise, &sent.noise, sizeof sent.noise);
    assert_int_equal(got.silent_units, 3);
    assert_int_equal(got.learned_value, TWD_LEARN_FROM_UNCLIPPED);
    assert_true(got.seed == sent.seed && sent.seed > UINT32_MAX);
}

/* A payload never outgrows its frame: what does not fit fails, and nothing is written beyond. */
static void payload_does_not_outgrow_its_frame(void **state)
{
    uint32_t words[100] = {0};
    struct {
        struct twd_frame frame;
        uint8_t beyond[64];
    } place;
    (void)state;
    memset(&place, 0xAA, sizeof place);
    struct twd_transfer transfer = twd_transfer_to(&place.frame);
    twd_transfer_words(&transfer, words, 100);
    assert_false(twd_transfer_end(&transfer));
    for (size_t i = 0; i < sizeof place.beyond; i++)
        assert_int_equal(place.beyond[i], 0xAA);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(controller_comes_back), cmocka_unit_test(controller_out_of_range_is_refused),
        cmocka_unit_test(finger_comes_back),     cmocka_unit_test(joint_comes_back),
        cmocka_unit_test(learner_comes_back),    cmocka_unit_test(payload_does_not_outgrow_its_frame),
    };
    return cmocka_run_group_tests_name("transfer", tests, NULL, NULL);
}
