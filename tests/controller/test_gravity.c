#include "controller_test.h"

#include <twiddle/gravity.h>

#define G 9.81
#define TOLERANCE_NM BY_NUMBER(1e-8, 1e-6)

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
    assert_int_equal(twd_gravity_init(&gravity, &chain, 1, NULL, TWD_NUM(G), down), TWD_OK);
    for (int k = -31; k <= 31; k++) {
        const twd_num q = (twd_num)(k / 10.0);
        twd_num torque;
        twd_gravity_torque(&gravity, &q, &torque);
        assert_close(torque, 0.2 * G * 0.15 * cos((double)q), TOLERANCE_NM);
    }
}

/* Two links are held by m2 g l2 cos(q1 + q2) at the second joint, and by that plus (m1 l1 + m2 L1) g cos(q1) at the
 * first. */
static void double_pendulum_is_held(void **state)
{
    (void)state;
    static const struct twd_chain chain = {2, pendulum_joint};
    struct twd_gravity gravity;
    assert_int_equal(twd_gravity_init(&gravity, &chain, 2, NULL, TWD_NUM(G), down), TWD_OK);
    for (int k = -15; k <= 15; k++) {
        const twd_num q[2] = {(twd_num)(k / 5.0), (twd_num)(1.0 - k / 10.0)};
        twd_num torque[2];
        twd_gravity_torque(&gravity, q, torque);
        const double second = 0.1 * G * 0.08 * cos((double)q[0] + (double)q[1]);
        assert_close(torque[1], second, TOLERANCE_NM);
        assert_close(torque[0], second + (0.2 * 0.15 + 0.1 * 0.3) * G * cos((double)q[0]), TOLERANCE_NM);
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
            rotation[row][column] = (twd_num)rows[row][column];
}

/* A finger-sized chain of four links, all random, and a direction of gravity. */
static void random_finger(uint64_t *random, struct twd_chain_joint joint[4], twd_num direction[3])
{
    twd_num rotation[3][3];
    for (int i = 0; i < 4; i++) {
        random_rotation(random, joint[i].rotation);
        joint[i].mass_kg = (twd_num)uniform(random, 0.0, 0.05);
        for (int axis = 0; axis < 3; axis++) {
            joint[i].origin_m[axis] = (twd_num)uniform(random, -0.1, 0.1);
            joint[i].centre_of_mass_m[axis] = (twd_num)uniform(random, -0.05, 0.05);
        }
    }
    random_rotation(random, rotation);
    for (int axis = 0; axis < 3; axis++)
        direction[axis] = rotation[axis][2];
}

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
                    unturned[r][c] += frame[r][k] * (double)joint[i].rotation[k][c];
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < 3; k++)
                    turned[r][c] += unturned[r][k] * turn[k][c];
        for (int r = 0; r < 3; r++) {
            for (int k = 0; k < 3; k++)
                origin[r] += frame[r][k] * (double)joint[i].origin_m[k];
            double centre = origin[r];
            for (int k = 0; k < 3; k++)
                centre += turned[r][k] * (double)joint[i].centre_of_mass_m[k];
            energy -= (double)joint[i].mass_kg * G * (double)direction[r] * centre;
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
    for (int repeat = 0; repeat < 500; repeat++) {
        struct twd_chain_joint joint[4];
        twd_num direction[3], angle[4], torque[4];
        random_finger(&random, joint, direction);
        for (int i = 0; i < 4; i++)
            angle[i] = (twd_num)uniform(&random, -3.1, 3.1);

        const uint8_t moving = (uint8_t)(1 + repeat % 4);
        const struct twd_chain chain = {4, joint};
        struct twd_gravity gravity;
        assert_int_equal(twd_gravity_init(&gravity, &chain, moving, angle + moving, TWD_NUM(G), direction), TWD_OK);
        twd_gravity_torque(&gravity, angle, torque);
        for (int i = 0; i < moving; i++) {
            double q[4] = {(double)angle[0], (double)angle[1], (double)angle[2], (double)angle[3]};
            const double step = 1e-5;
            q[i] += step;
            const double above = potential_energy(joint, direction, q);
            q[i] -= 2.0 * step;
            const double below = potential_energy(joint, direction, q);
            assert_close(torque[i], (above - below) / (2.0 * step), TOLERANCE_NM);
        }
    }
}

/* Holding the outer joints at some angles gives the same torques as moving them there: merging loses nothing. */
static void held_joints_weigh_as_if_they_moved(void **state)
{
    (void)state;
    uint64_t random = 77;
    print_message("seed 77\n");
    for (int repeat = 0; repeat < 200; repeat++) {
        struct twd_chain_joint joint[4];
        twd_num direction[3], angle[4], whole_nm[4];
        random_finger(&random, joint, direction);
        const struct twd_chain chain = {4, joint};
        struct twd_gravity whole;
        assert_int_equal(twd_gravity_init(&whole, &chain, 4, NULL, TWD_NUM(G), direction), TWD_OK);
        for (int i = 0; i < 4; i++)
            angle[i] = (twd_num)uniform(&random, -3.1, 3.1);
        twd_gravity_torque(&whole, angle, whole_nm);

        for (uint8_t moving = 1; moving < 4; moving++) {
            struct twd_gravity merged;
            twd_num merged_nm[4];
            assert_int_equal(twd_gravity_init(&merged, &chain, moving, angle + moving, TWD_NUM(G), direction), TWD_OK);
            assert_int_equal(merged.moving, moving);
            twd_gravity_torque(&merged, angle, merged_nm);
            for (int i = 0; i < moving; i++)
                assert_close(merged_nm[i], (double)whole_nm[i], TOLERANCE_NM);
        }
    }
}

/* Chains, angles, accelerations and directions outside their ranges are refused, and nothing is written. */
static void init_rejects_what_is_out_of_range(void **state)
{
    (void)state;
    static const twd_num straight[1] = {0};
    static const twd_num beyond[1] = {TWD_NUM(3.2)};
    static const twd_num short_direction[3] = {0, TWD_NUM(-0.9), 0};
    struct twd_chain_joint heavy[2] = {pendulum_joint[0], pendulum_joint[1]};
    heavy[1].mass_kg = (twd_num)NAN;
    const struct twd_chain good = {2, pendulum_joint}, empty = {0, pendulum_joint}, weightless = {2, heavy};
    const struct twd_chain endless = {TWD_MAX_CHAIN_JOINTS + 1, pendulum_joint};
    const twd_num g = TWD_NUM(G);
    struct twd_gravity gravity;
    struct twd_gravity before;
    memset(&gravity, 0x5A, sizeof gravity);
    memcpy(&before, &gravity, sizeof gravity);

    assert_int_equal(twd_gravity_init(&gravity, &empty, 1, straight, g, down), TWD_ERROR_CHAIN);
    assert_int_equal(twd_gravity_init(&gravity, &endless, 1, straight, g, down), TWD_ERROR_CHAIN);
    assert_int_equal(twd_gravity_init(&gravity, &good, 0, straight, g, down), TWD_ERROR_CHAIN);
    assert_int_equal(twd_gravity_init(&gravity, &good, 3, straight, g, down), TWD_ERROR_CHAIN);
    assert_int_equal(twd_gravity_init(&gravity, &weightless, 1, straight, g, down), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, beyond, g, down), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, TWD_NUM(21), down), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, -g, down), TWD_ERROR_RANGE);
    assert_int_equal(twd_gravity_init(&gravity, &good, 1, straight, g, short_direction), TWD_ERROR_RANGE);
    assert_memory_equal(&gravity, &before, sizeof gravity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(single_pendulum_is_held),
        cmocka_unit_test(double_pendulum_is_held),
        cmocka_unit_test(torques_are_slopes_of_the_potential_energy),
        cmocka_unit_test(held_joints_weigh_as_if_they_moved),
        cmocka_unit_test(init_rejects_what_is_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
