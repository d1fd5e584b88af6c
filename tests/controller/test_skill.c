/* A skill, and the set-up it is for: what they are made into, and what they refuse. */
#include "controller_fixture.h"

#include <twiddle/icub_right_hand.h>
#include <twiddle/skill.h>

/* Static, since they take 3 and 1.5 KiB. */
static struct twd_controller controller;
static struct twd_controller_config config;

#define INERTIA_KG_M2 TWD_SMALL(4e-5)
#define PERIOD_S TWD_SMALL(0.005)
#define GAINS                                                                                                          \
    {                                                                                                                  \
        TWD_NUM(0.3), TWD_NUM(0.01), TWD_NUM(0.5)                                                                      \
    }

/* The second joint with stable gains, and both fingers of the iCub hand, of which the thumb has three moving joints. */
static const struct twd_joint_setup joints[] = {
    {GAINS, TWD_SMALL(0)}, {GAINS, INERTIA_KG_M2}, {GAINS, TWD_SMALL(0)}, {GAINS, TWD_SMALL(0)}};
static const struct twd_finger_setup fingers[] = {
    {&twd_icub_index, 2, {TWD_ICUB_AAI, TWD_ICUB_FEI}, {TWD_NUM(0.1), TWD_NUM(0.2)}},
    {&twd_icub_thumb, 3, {TWD_ICUB_OT, TWD_ICUB_FET, TWD_ICUB_FEI}, {TWD_NUM(0.3)}}};
static const twd_num learned[] = {TWD_NUM(0.75), TWD_NUM(0.25), TWD_NUM(0.5), TWD_NUM(0.125), TWD_NUM(0.25)};

static struct twd_skill skill_of(const struct twd_model *model)
{
    const struct twd_skill skill = {
        .setup = {.model = model,
                  .oscillators = {.with_centre = true,
                                  .tick_s = TWD_SMALL(0.01),
                                  .amplitude_rate_per_s = TWD_RATE(20),
                                  .centre_rate_per_s = TWD_RATE(10),
                                  .return_lag = TWD_RETURN_LAG_EQUAL,
                                  .centre_start = TWD_CENTRE_START_AT_TARGET},
                  .phase_start = TWD_PHASE_START_AT_ZERO,
                  .saturation = TWD_SATURATE_EACH,
                  .ranges = {TWD_NUM(0.25), TWD_NUM(1.25), TWD_NUM(1), TWD_NUM(0.5), TWD_NUM(0.125), TWD_NUM(0.875)},
                  .torque_period_s = PERIOD_S,
                  .joints = TWD_ICUB_JOINTS,
                  .range = twd_icub_joint_range,
                  .joint = joints,
                  .fingers = 2,
                  .finger = fingers,
                  .gravity_m_s2 = TWD_WIDE(9.5),
                  .gravity_direction = {TWD_NUM(0), TWD_NUM(0.6), TWD_NUM(-0.8)}},
        .trial_ticks = 300,
        .parameters = sizeof learned / sizeof *learned,
        .parameter = learned,
    };
    return skill;
}

static void assert_same_bytes(const void *a, const void *b, size_t size)
{
    assert_int_equal(checksum(a, size), checksum(b, size));
}

/* Two joints that move have a table of their own; no other is compared, nor what lies beyond the moving joints. */
static void assert_same_gravity(const struct twd_gravity *a, const struct twd_gravity *b)
{
    assert_int_equal(a->moving, b->moving);
    assert_same_bytes(a->direction, b->direction, sizeof a->direction);
    assert_same_bytes(a->joint, b->joint, a->moving * sizeof a->joint[0]);
    if (a->moving == 2) assert_same_bytes(a->pair_energy_j, b->pair_energy_j, sizeof a->pair_energy_j);
}

/* A set-up becomes the configuration that a caller fills in field by field, with twd_gravity_init for each finger and
 * twd_pd_stable for the joint with an inertia. */
static void setup_becomes_the_configuration_by_hand(void **state)
{
    static const twd_num direction[3] = {TWD_NUM(0), TWD_NUM(0.6), TWD_NUM(-0.8)};
    static const twd_num index_held[2] = {TWD_NUM(0.1), TWD_NUM(0.2)};
    static const twd_num thumb_held[1] = {TWD_NUM(0.3)};
    static struct twd_gravity gravity;
    const struct twd_skill skill = skill_of(&twd_model_m);
    const struct twd_setup *const setup = &skill.setup;
    struct twd_pd stable = GAINS;
    (void)state;
    assert_int_equal(twd_setup_config(setup, &config), TWD_OK);

    assert_true(config.model == &twd_model_m);
    assert_true(config.oscillators.with_centre);
    assert_true(config.oscillators.tick_s == TWD_SMALL(0.01));
    assert_true(config.oscillators.amplitude_rate_per_s == TWD_RATE(20));
    assert_true(config.oscillators.centre_rate_per_s == TWD_RATE(10));
    assert_int_equal(config.oscillators.return_lag, TWD_RETURN_LAG_EQUAL);
    assert_int_equal(config.oscillators.centre_start, TWD_CENTRE_START_AT_TARGET);
    assert_int_equal(config.phase_start, TWD_PHASE_START_AT_ZERO);
    assert_int_equal(config.saturation, TWD_SATURATE_EACH);
    assert_same_bytes(&config.ranges, &setup->ranges, sizeof setup->ranges);

    assert_int_equal(config.joints, TWD_ICUB_JOINTS);
    assert_int_equal(twd_pd_stable(&stable, INERTIA_KG_M2, PERIOD_S, &stable), TWD_OK);
    for (int j = 0; j < TWD_ICUB_JOINTS; j++) {
        assert_true(config.joint[j].range.lower_rad == twd_icub_joint_range[j].lower_rad);
        assert_true(config.joint[j].range.upper_rad == twd_icub_joint_range[j].upper_rad);
        assert_same_bytes(&config.joint[j].pd, j == 1 ? &stable : &joints[j].pd, sizeof stable);
    }

    assert_int_equal(config.fingers, 2);
    assert_int_equal(twd_gravity_init(&gravity, &twd_icub_index, 2, index_held, TWD_WIDE(9.5), direction), TWD_OK);
    assert_same_gravity(&config.finger[0].gravity, &gravity);
    assert_int_equal(twd_gravity_init(&gravity, &twd_icub_thumb, 3, thumb_held, TWD_WIDE(9.5), direction), TWD_OK);
    assert_same_gravity(&config.finger[1].gravity, &gravity);
    assert_same_bytes(config.finger[0].joint, fingers[0].joint, sizeof fingers[0].joint);
    assert_same_bytes(config.finger[1].joint, fingers[1].joint, sizeof fingers[1].joint);
}

/* A checksum of a second of movement: desired angles, and torques at made-up angles. */
static uint32_t movement(void)
{
    uint32_t sum = 0;
    for (int tick = 0; tick < 100; tick++) {
        static const twd_num angle_rad[4] = {TWD_NUM(0.1), TWD_NUM(0.2), TWD_NUM(0.3), TWD_NUM(0.4)};
        static const twd_rate velocity_rad_s[4] = {TWD_RATE(1), TWD_RATE(0), TWD_RATE(-1), TWD_RATE(2)};
        twd_num desired_rad[4], torque_nm[4];
        twd_controller_tick(&controller, desired_rad);
        twd_controller_torque(&controller, desired_rad, angle_rad, velocity_rad_s, torque_nm);
        sum = sum * 31U + checksum(desired_rad, sizeof desired_rad);
        sum = sum * 31U + checksum(torque_nm, sizeof torque_nm);
    }
    return sum;
}

/* A skill moves as a controller that is made of its configuration and started with its parameters, in the same and in a
 * used controller. */
static void skill_moves_as_its_controller(void **state)
{
    const struct twd_skill skill = skill_of(&twd_model_m);
    (void)state;
    assert_int_equal(twd_setup_config(&skill.setup, &config), TWD_OK);
    assert_int_equal(twd_controller_init(&controller, &config), TWD_OK);
    assert_int_equal(twd_controller_start(&controller, learned, 5), TWD_OK);
    const uint32_t expected = movement();
    assert_int_equal(twd_skill_start(&skill, &controller), TWD_OK);
    assert_int_equal(movement(), expected);
    memset(&controller, 0, sizeof controller);
    assert_int_equal(twd_skill_start(&skill, &controller), TWD_OK);
    assert_int_equal(movement(), expected);
}

/* Each wrong field is refused with its error. */
static void wrong_skills_are_refused(void **state)
{
    static const struct twd_joint_setup bad_inertia[4] = {{GAINS, TWD_SMALL(-0.001)}};
    static const struct twd_finger_setup bad_finger[2] = {{&twd_icub_index, 5, {0}, {TWD_NUM(0)}}};
    static const struct twd_finger_setup no_chain[2] = {{NULL, 1, {0}, {TWD_NUM(0)}}};
    static const struct twd_finger_setup bad_joint[2] = {{&twd_icub_index, 4, {0, 1, 2, 4}, {TWD_NUM(0)}},
                                                         {&twd_icub_thumb, 4, {0, 1, 2, 3}, {TWD_NUM(0)}}};
    static const twd_num bad_parameter[5] = {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1.5), TWD_NUM(0), TWD_NUM(0)};
    const struct twd_skill good = skill_of(&twd_model_m);
    (void)state;
    assert_int_equal(twd_skill_start(&good, &controller), TWD_OK);
#define REFUSED(field, value, error)                                                                                   \
    do {                                                                                                               \
        struct twd_skill wrong = good;                                                                                 \
        wrong.field = (value);                                                                                         \
        assert_int_equal(twd_skill_start(&wrong, &controller), (error));                                               \
    } while (0)
    REFUSED(parameter, NULL, TWD_ERROR_NULL);
    REFUSED(setup.model, NULL, TWD_ERROR_NULL);
    REFUSED(setup.range, NULL, TWD_ERROR_NULL);
    REFUSED(setup.joint, NULL, TWD_ERROR_NULL);
    REFUSED(setup.finger, NULL, TWD_ERROR_NULL);
    REFUSED(setup.finger, no_chain, TWD_ERROR_NULL);
    REFUSED(setup.joints, 0, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(setup.joints, 3, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(setup.joints, TWD_MAX_JOINTS + 1, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(setup.fingers, TWD_MAX_CHAINS + 1, TWD_ERROR_CHAIN);
    REFUSED(setup.finger, bad_finger, TWD_ERROR_CHAIN);
    REFUSED(setup.finger, bad_joint, TWD_ERROR_CHAIN);
    REFUSED(setup.joint, bad_inertia, TWD_ERROR_RANGE);
    REFUSED(setup.torque_period_s, TWD_SMALL(0), TWD_ERROR_TICK);
    REFUSED(setup.oscillators.tick_s, TWD_SMALL(0), TWD_ERROR_TICK);
    REFUSED(setup.gravity_m_s2, TWD_WIDE(21), TWD_ERROR_RANGE);
    REFUSED(parameters, 4, TWD_ERROR_PARAMETER_COUNT);
    REFUSED(parameter, bad_parameter, TWD_ERROR_PARAMETER);
#undef REFUSED
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(setup_becomes_the_configuration_by_hand),
        cmocka_unit_test(skill_moves_as_its_controller),
        cmocka_unit_test(wrong_skills_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
