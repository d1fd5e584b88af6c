/* The golden program: the controller and the learner of the fixed build through many cases, and a checksum of all that
 * they computed, which is the same on every machine and for every compiler (tests/firmware/golden). It writes one line,
 *
 *     golden: ticks XXXXXXXX learning XXXXXXXX
 *
 * Its constants are words, or have words of at most 24 significant bits, so that a compiler whose double has no more of
 * them (avr-gcc) makes the same of them. */
#include <board.h>
#include <twiddle/icub_right_hand.h>
#include <twiddle/input_map.h>
#include <twiddle/pd.h>

#include "checksum.h"

enum { SETS = 100, TICKS = 300, TRIALS = 1000, JOINTS = TWD_ICUB_JOINTS, PARAMETERS = 22 };

/* 0.01 s and 0.001 s. */
#define CENTISECOND ((twd_small)INT32_C(171798692))
#define MILLISECOND ((twd_small)INT32_C(17179869))

static struct twd_controller controller;
static struct twd_controller_config config;
static struct twd_learner learner;
static struct twd_random random_state;

static void require(enum twd_error error)
{
    if (error == TWD_OK) return;
    board_write("golden: ");
    board_write(twd_error_text(error));
    board_write("\n");
    board_exit(BOARD_FAILURE);
}

/* A word of +-2^(bits - 1). */
static int32_t random_word(unsigned bits)
{
    return (int32_t)((twd_random_next(&random_state) >> (32U - bits)) - (UINT32_C(1) << (bits - 1U)));
}

/* The finger's first joints move, as many as `moving`; the others are held at a quarter rad. Gravity: 9.81 m/s2. */
static void set_finger(struct twd_finger *finger, const struct twd_chain *chain, uint8_t moving,
                       const enum twd_icub_joint *joint)
{
    static const twd_num held_rad[4] = {TWD_NUM(0.25), TWD_NUM(0.25), TWD_NUM(0.25), TWD_NUM(0.25)};
    static const twd_num direction[3] = {TWD_NUM_CONSTANT(-0.96592582628906829, -259288735), TWD_NUM(0),
                                         TWD_NUM_CONSTANT(0.25881904510252076, 69476207)};
    for (uint8_t i = 0; i < moving; i++)
        finger->joint[i] = (uint8_t)joint[i];
    require(twd_gravity_init(&finger->gravity, chain, moving, held_rad, TWD_WIDE_CONSTANT(9.81, 164584489), direction));
}

/* Joint ranges of the iCub hand, and gains that twd_pd_stable softens. */
static void set_joints(void)
{
    static const struct twd_pd stiff = {TWD_NUM(0.3125), TWD_NUM(0.0078125), TWD_NUM(0.5)};
    config.joints = JOINTS;
    for (size_t j = 0; j < JOINTS; j++) {
        config.joint[j].range = twd_icub_joint_range[j];
        require(twd_pd_stable(&stiff, TWD_SMALL(0.0001220703125), TWD_SMALL(0.001953125), &config.joint[j].pd));
    }
}

/* Every set has another mixture of the settings, and filters that are a little faster than the last one's. */
static void configure(int set)
{
    static const struct twd_model *const models[] = {&twd_model_h, &twd_model_h, &twd_model_h, &twd_model_c,
                                                     &twd_model_h, &twd_model_m, &twd_model_h, &twd_model_s};
    static const enum twd_icub_joint index_joints[] = {TWD_ICUB_AAI, TWD_ICUB_FEI, TWD_ICUB_FET, TWD_ICUB_OT};
    static const enum twd_icub_joint thumb_joints[] = {TWD_ICUB_OT, TWD_ICUB_FET};
    static const struct twd_parameter_ranges ranges = {TWD_NUM(0.25), TWD_NUM(2), TWD_NUM(1),
                                                       TWD_NUM(0.5),  TWD_NUM(0), TWD_NUM(1)};
    config.model = models[set % 8];
    config.oscillators.with_centre = set % 2 == 0;
    config.oscillators.tick_s = set / 2 % 2 == 0 ? CENTISECOND : MILLISECOND;
    config.oscillators.amplitude_rate_per_s = (twd_rate)((20 + (int32_t)set) << TWD_RATE_BITS);
    config.oscillators.centre_rate_per_s = (twd_rate)((120 - (int32_t)set) << TWD_RATE_BITS);
    config.oscillators.return_lag = set / 4 % 2 == 0 ? TWD_RETURN_LAG_NEGATED : TWD_RETURN_LAG_EQUAL;
    config.oscillators.centre_start = (enum twd_centre_start)(set % 3);
    config.phase_start = set / 8 % 2 == 0 ? TWD_PHASE_START_AT_ZERO : TWD_PHASE_START_AT_LAG;
    config.saturation = set / 16 % 2 == 0 ? TWD_SATURATE_SUM : TWD_SATURATE_EACH;
    config.ranges = ranges;
    config.fingers = 2;
    /* Two moving joints have a path of their own in the library. */
    set_finger(&config.finger[0], &twd_icub_index, set % 5 == 0 ? 4 : 2, index_joints);
    set_finger(&config.finger[1], &twd_icub_thumb, 2, thumb_joints);
}

/* Start with parameters in [0, 1), or all at an end of it. */
static void start(int set)
{
    const size_t count = twd_model_parameters(config.model, config.oscillators.with_centre);
    twd_num parameter[PARAMETERS];
    for (size_t i = 0; i < count; i++)
        parameter[i] = (twd_num)(int32_t)(twd_random_next(&random_state) >> 4);
    for (size_t i = 0; i < count && set % 50 >= 48; i++)
        parameter[i] = set % 2 == 0 ? TWD_NUM(1) : TWD_NUM(0);
    require(twd_controller_start(&controller, parameter, count));
}

/* Made-up motion: +-2 rad and +-32 rad/s, every 16th tick all that a word can say, and now and then what is no
 * number. */
static void move(int tick, twd_num *angle_rad, twd_rate *velocity_rad_s)
{
    const unsigned more_bits = tick % 16 == 15 ? 2 : 0;
    for (size_t j = 0; j < JOINTS; j++) {
        angle_rad[j] = (twd_num)random_word(30U + more_bits);
        velocity_rad_s[j] = (twd_rate)random_word(26U + 3U * more_bits);
    }
    if (tick % 64 == 63) angle_rad[tick / 64 % JOINTS] = (twd_num)INT32_MIN;
}

static uint32_t ticks(void)
{
    uint32_t sum = CHECKSUM_START;
    twd_random_seed(&random_state, 20110824U);
    set_joints();
    for (int set = 0; set < SETS; set++) {
        configure(set);
        require(twd_controller_init(&controller, &config));
        start(set);
        for (int tick = 0; tick < TICKS; tick++) {
            twd_num desired_rad[JOINTS], angle_rad[JOINTS], torque_nm[JOINTS];
            twd_rate velocity_rad_s[JOINTS];
            move(tick, angle_rad, velocity_rad_s);
            twd_controller_tick(&controller, desired_rad);
            twd_controller_torque(&controller, desired_rad, angle_rad, velocity_rad_s, torque_nm);
            checksum_numbers(&sum, desired_rad, JOINTS);
            checksum_numbers(&sum, torque_nm, JOINTS);
        }
        checksum_controller(&sum, &controller);
    }
    return sum;
}

/* At most 4, where every parameter is at its target: a quarter or three quarters in turns. */
static twd_wide reward(const twd_num *parameter)
{
    twd_wide sum = TWD_WIDE(4);
    for (size_t i = 0; i < PARAMETERS; i++) {
        const twd_num distance = parameter[i] - (i % 2 == 0 ? TWD_NUM(0.25) : TWD_NUM(0.75));
        sum -= twd_wide_product(distance, distance);
    }
    return sum;
}

/* Another object every ten trials: three sizes of each shape. */
static void see(int trial, twd_num *input)
{
    static const twd_num size_m[] = {TWD_NUM(0.02734375), TWD_NUM(0.03125), TWD_NUM(0.037109375)};
    const int object = trial / 10;
    twd_input_map((enum twd_shape)(object % TWD_SHAPES), size_m[object / TWD_SHAPES % 3], TWD_WIDE(10), input);
}

static uint32_t learning(void)
{
    static const struct twd_learner_config learner_config = {
        .units = PARAMETERS,
        .inputs = TWD_INPUTS,
        .actor_rate = TWD_NUM(0.1),
        .critic_rate = TWD_NUM(0.1),
        .weight_range = TWD_NUM(0.05),
        .clip = TWD_NUM(0.001),
        .noise = {.start = TWD_NUM(0.5), .end = TWD_NUM(0.05), .decay_fraction = TWD_NUM(0.625), .trials = TRIALS},
        .silent_units = 3,
        .seed = 1,
    };
    uint32_t sum = CHECKSUM_START;
    twd_num input[TWD_INPUTS], parameter[PARAMETERS];
    require(twd_learner_init(&learner, &learner_config));
    for (int trial = 0; trial < TRIALS; trial++) {
        if (trial % 10 == 0) see(trial, input);
        twd_learner_act(&learner, input, parameter);
        const twd_wide td_error = twd_learner_learn(&learner, reward(parameter));
        checksum_numbers(&sum, &td_error, 1);
    }
    checksum_learner(&sum, &learner);
    twd_learner_policy(&learner, input, parameter);
    checksum_numbers(&sum, parameter, PARAMETERS);
    return sum;
}

static void write_hexadecimal(uint32_t value)
{
    char text[9];
    for (unsigned i = 0; i < 8; i++)
        text[i] = "0123456789ABCDEF"[(value >> (28U - 4U * i)) & 15U];
    text[8] = '\0';
    board_write(text);
}

int main(void)
{
    const uint32_t sum_of_ticks = ticks();
    const uint32_t sum_of_learning = learning();
    board_write("golden: ticks ");
    write_hexadecimal(sum_of_ticks);
    board_write(" learning ");
    write_hexadecimal(sum_of_learning);
    board_write("\n");
    return BOARD_SUCCESS;
}
