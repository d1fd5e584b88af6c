#include "controller_test.h"

#include <twiddle/gravity.h>

#define G 9.81
/* Fixed: sines within 4e-6, of moments of less than 0.5 N m. */
#define TOLERANCE_NM BY_NUMBER(1e-8, 1e-6, 2e-6)

/* Two links along x that turn about z in one plane; gravity along -y. */
static const struct twd_chain_joint pendulum_joint[] = {
    {.rotation = {{TWD_NUM(1), 0, 0}, {0, TWD_NUM(1), 0}, {0, 0, TWD_NUM(1)}},
     .origin_m = {TWD_NUM(0.01), TWD_NUM(0.02), TWD_NUM(0.03)},
     .mass_kg = TWD_NUM(0.2),
     .centre_of_mass_m = {TWD_NUM(0.15), 0, 0}},
    {.rotation = {{TWD_NUM(1), 0, 0}, {0, TWD_NUM(1), 0}, {0, 0, TWD_NUM(1)}},
     .origin_m = {TWD_NUM(0.3), 0, 0},
     .mass_kg = TWD_NUM(0.1),
     .centre_of_mass_m = {TWD_NUM(0.08), 0, 0}},
};
static const twd_num down[3] = {0, TWD_NUM(-1), 0};

/* One link at angle q is held by m g l cos(q). */
static void single_pendulum_is_held(void **state)
{
    (void)state;
    static const struct twd_chain chain = {1, pendulum_joint};
    struct twd_gravity gravity;
    assert_int_equal(twd_gravity_init(&gravity, &chain, 1, NULL, TWD_WIDE(G), down), TWD_OK);
    for (int k = -31; k <= 31; k++) {
        const twd_num q = twd_num_from_double(k / 10.0);
        twd_num torque;
        twd_gravity_torque(&gravity, &q, &torque);
        assert_num_close(torque, 0.2 * G * 0.15 * cos(twd_num_to_double(q)), TOLERANCE_NM);
    }
}

/* Two links are held by m2 g l2 cos(q1 + q2) at the second joint, and by that plus (m1 l1 + m2 L1) g cos(q1) at the
 * first. */
static void double_pendulum_is_held(void **state)
{
    (void)state;
    static const struct twd_chain chain = {2, pendulum_joint};
    struct twd_gravity gravity;
    assert_int_equal(twd_gravity_init(&gravity, &chain, 2, NULL, TWD_WIDE(G), down), TWD_OK);
    for (int k = -15; k <= 15; k++) {
        const twd_num q[2] = {twd_num_from_double(k / 5.0), twd_num_from_double(1.0 - k / 10.0)};
        twd_num torque[2];
        twd_gravity_torque(&gravity, q, torque);
        const double first_rad = twd_num_to_double(q[0]);
        const double second = 0.1 * G * 0.08 * cos(first_rad + twd_num_to_double(q[1]));
        assert_num_close(torque[1], second, TOLERANCE_NM);
        assert_num_close(torque[0], second + (0.2 * 0.15 + 0.1 * 0.3) * G * cos(first_rad), TOLERANCE_NM);
    }
}

/* A rotation by three random angles about z, y and x, as rows. */
static void random_rotation(uint64_t *random, twd_num rotation[3][3])
{
    const double a = uniform(random, -PI, PI), b = uniform(random, -PI, PI), c = uniform(random, -PI, PI);
    const double rows[3][3] = {
        {cos(a) * cos(b), cos(a) * sin(b) * sin(c) - sin(a) * cos(c), cos(a) * sin(b) * cos(c) + sin(a) * sin(c)},
        {sin(a) * cos(b), sin(a) * sin(b) * sin(c) + cos(a) * cos(c), sin(a) * sin(b) * cos(c) - cos(a) * sin(c)},
        {-sin(b), cos(b) * sin(c), cos(b) * cos(c)}};
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            rotation[row][column] = twd_num_from_double(rows[row][column]);
}

/* A finger-sized chain of four links, all random, and a direction of gravity. */
static void random_finger(uint64_t *random, struct twd_chain_joint joint[4], twd_num direction[3])
{
    twd_num rotation[3][3];
    for (int i = 0; i < 4; i++) {
        random_rotation(random, joint[i].rotation);
        joint[i].mass_kg = twd_num_from_double(uniform(random, 0.0, 0.05));
        for (int axis = 0; axis < 3; axis++) {
            joint[i].origin_m[axis] = twd_num_from_double(uniform(random, -0.1, 0.1));
            joint[i].centre_of_mass_m[axis] = twd_num_from_double(uniform(random, -0.05, 0.05));
        }
    }
    random_rotation(random, rotation);
    for (int axis = 0; axis < 3; axis++)
        direction[axis] = rotation[axis][2];
}

#if DBL_MANT_DIG >= 53 /* the slopes need it */
/* Potential energy of the chain at angles q, J: minus the sum of m g (direction . centre of mass), by forward
 * kinematics. */
static double potential_energy(const struct twd_chain_joint joint[4], const twd_num direction[3], const double q[4])
{
    double frame[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double origin[3] = {0, 0, 0};
    double energy = 0.0;
    for (int i = 0; i < 4; i++) {
        const double turn[3][3] = {{cos(q[i]), -sin(q[i]), 0}, {sin(q[i]), cos(q[i]), 0}, {0, 0, 1}};
        double unturned[3][3] = {{0}}, turned[3][3] = {{0}};
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < 3; k++)
                    unturned[r][c] += frame[r][k] * twd_num_to_double(joint[i].rotation[k][c]);
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < 3; k++)
                    turned[r][c] += unturned[r][k] * turn[k][c];
        for (int r = 0; r < 3; r++) {
            for (int k = 0; k < 3; k++)
                origin[r] += frame[r][k] * twd_num_to_double(joint[i].origin_m[k]);
            double centre = origin[r];
            for (int k = 0; k < 3; k++)
                centre += turned[r][k] * twd_num_to_double(joint[i].centre_of_mass_m[k]);
            energy -= twd_num_to_double(joint[i].mass_kg) * G * twd_num_to_double(direction[r]) * centre;
        }
        memcpy(frame, turned, sizeof frame);
    }
    return energy;
}

/* 500 random chains in space, of which the first one, two, three or all four joints move: the torques are the slopes of
 * the potential energy, from central differences in double. */
static void torques_are_slopes_of_the_potential_energy(void **state)
{
    (void)state;
    uint64_t random = 2024;
    print_message("seed 2024\n");
    for (int32_t repeat = 0; repeat < CASES(500); repeat++) {
        struct twd_chain_joint joint[4];
        twd_num direction[3], angle[4], torque[4];
        random_finger(&random, joint, direction);
        for (int i = 0; i < 4; i++)
            angle[i] = twd_num_from_double(uniform(&random, -3.1, 3.1));

        const uint8_t moving = (uint8_t)(1 + repeat % 4);
        const struct twd_chain chain = {4, joint};
        struct twd_gravity gravity;
        assert_int_equal(twd_gravity_init(&gravity, &chain, moving, angle + moving, TWD_WIDE(G), direction), TWD_OK);
        twd_gravity_torque(&gravity, angle, torque);
        for (int i = 0; i < moving; i++) {
            double q[4] = {twd_num_to_double(angle[0]), twd_num_to_double(angle[1]), twd_num_to_double(angle[2]),
                           twd_num_to_double(angle[3])};
            const double step = 1e-5;
            q[i] += step;
            const double above = potential_energy(joint, direction, q);
            q[i] -= 2.0 * step;
            const double below = potential_energy(joint, direction, q);
            assert_num_close(torque[i], (above - below) / (2.0 * step), TOLERANCE_NM);
        }
    }
}
#endif

/* Holding the outer joints at some angles gives the same torques as moving them there: merging loses nothing. */
static void held_joints_weigh_as_if_they_moved(void **state)
{
    (void)state;
    uint64_t random = 77;
    print_message("seed 77\n");
    for (int32_t repeat = CASES(200); repeat > 0; repeat--) {
        struct twd_chain_joint joint[4];
        twd_num direction[3], angle[4], whole_nm[4];
        random_finger(&random, joint, direction);
        const struct twd_chain chain = {4, joint};
        struct twd_gravity whole;
        assert_int_equal(twd_gravity_init(&whole, &chain, 4, NULL, TWD_WIDE(G), direction), TWD_OK);
        for (int i = 0; i < 4; i++)
            angle[i] = twd_num_from_double(uniform(&random, -3.1, 3.1));
        twd_gravity_torque(&whole, angle, whole_nm);

        for (uint8_t moving = 1; moving < 4; moving++) {
            struct twd_gravity merged;
            twd_num merged_nm[4];
            assert_int_equal(twd_gravity_init(&merged, &chain, moving, angle + moving, TWD_WIDE(G), direction), TWD_OK);
            assert_int_equal(merged.moving, moving);
            twd_gravity_torque(&merged, angle, merged_nm);
            for (int i = 0; i < moving; i++)
                assert_num_close(merged_nm[i], twd_num_to_double(whole_nm[i]), TOLERANCE_NM);
        }
    }
}

/* Chains, angles, accelerations and directions outside their ranges are refused, and nothing is written. */
static void init_rejects_what_is_out_of_range(void **state)
{
    (void)state;
    static const twd_num straight[1] = {TWD_NUM(0)};
    static const twd_num beyond[1] = {TWD_NUM(3.2)};
    static const twd_num short_direction[3] = {TWD_NUM(0), TWD_NUM(-0.9), TWD_NUM(0)};
    static const twd_num long_direction[3] = {TWD_NUM(0.8), TWD_NUM(-0.8), TWD_NUM(0)};
    static const twd_num far_direction[3] = {TWD_NUM(0), TWD_NUM(7), TWD_NUM(0)};
    const twd_num no_direction[3] = {TWD_NUM(0), twd_num_from_double((double)NAN), TWD_NUM(0)};
    const struct twd_chain good = {2, pendulum_joint}, empty = {0, pendulum_joint};
    const struct twd_chain endless = {TWD_MAX_CHAIN_JOINTS + 1, pendulum_joint};
    const twd_wide g = TWD_WIDE(G), no_acceleration = twd_wide_from_double((double)NAN);
    static struct twd_gravity gravity;
    mark(&gravity, sizeof gravity);
    assert_int_equal(twd_gravity_init(&gravity, &empty, 1, straight, g, down), TWD_ERROR_CHAIN);
    assert_int_equal(twd_gravity_init(&gravity, &endless, 1, straight, g, down), TWD_ERROR_CHAIN);
    assert_int_equal(twd_gravity_init(&gravity, &good, 0, straight, g, down), TWD_ERROR_CHAIN);
    assert_int_equal(twd_gravity_init(&gravity, &good, 3, straight, g, down), TWD_ERROR_CHAIN);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, beyond, g, down), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, TWD_WIDE(21), down), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, -g, down), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, no_acceleration, down), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, g, short_direction), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, g, long_direction), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, g, far_direction), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, g, no_direction), TWD_ERROR_RANGE);
    assert_marked(&gravity, sizeof gravity);
}

/* A link whose mass, lengths or frame are no numbers, or no frame, is refused, and nothing is written. */
static void init_rejects_links_that_are_none(void **state)
{
    (void)state;
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1e30};
    static struct twd_gravity gravity;
    static struct twd_chain_joint joint[2];
    const struct twd_chain chain = {2, joint};
    mark(&gravity, sizeof gravity);
#define REFUSED(field, value)                                                                                          \
    do {                                                                                                               \
        joint[0] = pendulum_joint[0];                                                                                  \
        joint[1] = pendulum_joint[1];                                                                                  \
        joint[1].field = (value);                                                                                      \
        assert_int_equal(twd_gravity_init(&gravity, &chain, 2, NULL, TWD_WIDE(G), down), TWD_ERROR_RANGE);             \
    } while (0)
    REFUSED(mass_kg, TWD_NUM(-0.1));
    REFUSED(rotation[1][1], TWD_NUM(1.1));
    REFUSED(rotation[1][1], TWD_NUM(0.5));
    REFUSED(rotation[1][0], TWD_NUM(1));
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        REFUSED(mass_kg, twd_num_from_double(bad[k]));
        REFUSED(origin_m[2], twd_num_from_double(bad[k]));
        REFUSED(centre_of_mass_m[0], twd_num_from_double(bad[k]));
        REFUSED(rotation[0][2], twd_num_from_double(bad[k]));
    }
#undef REFUSED
    assert_marked(&gravity, sizeof gravity);
}

/* Whatever the masses and lengths of a link, its chain is held by the closed-form torque m g l cos(q), within a part of
 * 1e-6, or refused: the fixed build takes weights below 8 N and moments up to 4 N m, the others 1e6 N m. */
static void heavy_links_are_held_or_refused(void **state)
{
    (void)state;
    static const struct {
        double mass_kg, length_m;
        bool in_float, in_fixed; /* held */
    } cases[] = {{0.1, 0.1, true, true},       {0.8, 0.5, true, true},  {0.8, 0.52, true, false},
                 {0.82, 0.1, true, false},     {3.0, 0.1, true, false}, {7.9, 0.01, true, false},
                 {0.001, 7.0, true, true},     {7.0, 7.0, true, false}, {500.0, 200.0, true, false},
                 {500.0, 210.0, false, false}, {9e5, 9e5, false, false}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct twd_chain_joint joint = pendulum_joint[0];
        joint.mass_kg = twd_num_from_double(cases[k].mass_kg);
        joint.centre_of_mass_m[0] = twd_num_from_double(cases[k].length_m);
        const struct twd_chain chain = {1, &joint};
        struct twd_gravity gravity;
        const enum twd_error error = twd_gravity_init(&gravity, &chain, 1, NULL, TWD_WIDE(G), down);
        const bool held = BY_NUMBER(cases[k].in_float, cases[k].in_float, cases[k].in_fixed);
        assert_int_equal(error, held ? TWD_OK : TWD_ERROR_RANGE);
        if (!held) continue;
        const twd_num angle = TWD_NUM(0.5);
        const double expected = cases[k].mass_kg * G * cases[k].length_m * cos(0.5);
        twd_num torque;
        twd_gravity_torque(&gravity, &angle, &torque);
        assert_num_close(torque, expected, expected * 2e-6 + BY_NUMBER(0.0, 0.0, 1e-6));
    }
}

/* A weight far out counts as well: behind a link without weight, at the end of a long one. */
static void weights_beyond_count(void **state)
{
    (void)state;
    static const struct {
        double mass_kg, length_m;
        bool in_fixed; /* held */
    } cases[] = {{0.1, 3.0, true}, {0.1, 4.2, false}, {0.8, 0.4, true}, {0.9, 0.1, false}, {5.0, 5.0, false}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        static struct twd_chain_joint joint[2];
        joint[0] = joint[1] = pendulum_joint[0];
        joint[0].mass_kg = TWD_NUM(0);
        joint[1].mass_kg = twd_num_from_double(cases[k].mass_kg);
        joint[1].origin_m[0] = twd_num_from_double(cases[k].length_m);
        joint[1].origin_m[1] = joint[1].origin_m[2] = joint[1].centre_of_mass_m[0] = TWD_NUM(0);
        const struct twd_chain chain = {2, joint};
        static struct twd_gravity gravity;
        const enum twd_error error = twd_gravity_init(&gravity, &chain, 2, NULL, TWD_WIDE(G), down);
        assert_int_equal(error, BY_NUMBER(true, true, cases[k].in_fixed) ? TWD_OK : TWD_ERROR_RANGE);
        if (error != TWD_OK) continue;
        static const twd_num angle[2] = {TWD_NUM(0.5), TWD_NUM(1)};
        const double expected = cases[k].mass_kg * G * cases[k].length_m * cos(0.5);
        twd_num torque[2];
        twd_gravity_torque(&gravity, angle, torque);
        assert_num_close(torque[0], expected, expected * 2e-6 + BY_NUMBER(0.0, 0.0, 1e-6));
        assert_num_close(torque[1], 0.0, 1e-6);
    }
}

/* A chain, its table, a direction or held angles that are null are refused, and nothing is written. */
static void init_rejects_null(void **state)
{
    (void)state;
    static const twd_num straight[1] = {TWD_NUM(0)};
    const struct twd_chain good = {2, pendulum_joint}, without_table = {2, NULL};
    static struct twd_gravity gravity;
    mark(&gravity, sizeof gravity);
    assert_int_equal(twd_gravity_init(&gravity, NULL, 1, straight, TWD_WIDE(G), down), TWD_ERROR_NULL);
    assert_int_equal(twd_gravity_init(&gravity, &without_table, 1, straight, TWD_WIDE(G), down), TWD_ERROR_NULL);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, TWD_WIDE(G), NULL), TWD_ERROR_NULL);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, NULL, TWD_WIDE(G), down), TWD_ERROR_NULL);
    assert_marked(&gravity, sizeof gravity);
    assert_int_equal(twd_gravity_init(&gravity, &good, 2, NULL, TWD_WIDE(G), down), TWD_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(single_pendulum_is_held),
        cmocka_unit_test(double_pendulum_is_held),
#if DBL_MANT_DIG >= 53
        cmocka_unit_test(torques_are_slopes_of_the_potential_energy),
#endif
        cmocka_unit_test(held_joints_weigh_as_if_they_moved),
        cmocka_unit_test(heavy_links_are_held_or_refused),
        cmocka_unit_test(weights_beyond_count),
        cmocka_unit_test(init_rejects_what_is_out_of_range),
        cmocka_unit_test(init_rejects_links_that_are_none),
        cmocka_unit_test(init_rejects_null),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
