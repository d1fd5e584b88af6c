#include <twiddle/gravity.h>

#include <twiddle/elementary.h>

#include "checks.h"

/* Into a joint's turned frame, from its parent's: Rz(-q) R^T v. */
static void to_link(const struct twd_gravity_joint *joint, twd_num sine, twd_num cosine, const twd_num v[3],
                    twd_num out[3])
{
    twd_num unturned[3];
    for (int column = 0; column < 3; column++)
        unturned[column] = twd_mul(joint->rotation[0][column], v[0]) + twd_mul(joint->rotation[1][column], v[1]) +
                           twd_mul(joint->rotation[2][column], v[2]);
    out[0] = twd_mul(cosine, unturned[0]) + twd_mul(sine, unturned[1]);
    out[1] = twd_mul(cosine, unturned[1]) - twd_mul(sine, unturned[0]);
    out[2] = unturned[2];
}

/* Out of a joint's turned frame, into its parent's: R Rz(q) v. */
static void to_parent(const struct twd_gravity_joint *joint, twd_num sine, twd_num cosine, const twd_num v[3],
                      twd_num out[3])
{
    const twd_num turned[3] = {twd_mul(cosine, v[0]) - twd_mul(sine, v[1]), twd_mul(sine, v[0]) + twd_mul(cosine, v[1]),
                               v[2]};
    for (int row = 0; row < 3; row++)
        out[row] = twd_mul(joint->rotation[row][0], turned[0]) + twd_mul(joint->rotation[row][1], turned[1]) +
                   twd_mul(joint->rotation[row][2], turned[2]);
}

/* Add to the parent's weight times centre of mass that of a body in the frame of `joint`. */
static void add_to_parent(const struct twd_gravity_joint *joint, twd_num sine, twd_num cosine, twd_num weight_n,
                          const twd_num moment_nm[3], twd_num parent_moment_nm[3])
{
    twd_num turned[3];
    to_parent(joint, sine, cosine, moment_nm, turned);
    for (int axis = 0; axis < 3; axis++)
        parent_moment_nm[axis] += turned[axis] + twd_mul(weight_n, joint->origin_m[axis]);
}

static enum twd_error check_chain(const struct twd_chain *chain)
{
    for (uint8_t i = 0; i < chain->joints; i++) {
        const struct twd_chain_joint *const joint = &chain->joint[i];
        if (!(joint->mass_kg >= TWD_NUM(0)) || !twd_is_usable(joint->mass_kg)) return TWD_ERROR_RANGE;
        for (int axis = 0; axis < 3; axis++) {
            if (!twd_is_usable(joint->origin_m[axis]) || !twd_is_usable(joint->centre_of_mass_m[axis]))
                return TWD_ERROR_RANGE;
            for (int column = 0; column < 3; column++)
                if (!twd_within(joint->rotation[axis][column], TWD_NUM(-1.001), TWD_NUM(1.001))) return TWD_ERROR_RANGE;
        }
    }
    return TWD_OK;
}

static enum twd_error check_gravity(const twd_num *held_angle_rad, uint8_t held, twd_num acceleration_m_s2,
                                    const twd_num direction[3])
{
    const twd_num half_turn_rad = TWD_NUM(3.14159265358979324);
    for (uint8_t i = 0; i < held; i++)
        if (!twd_within(held_angle_rad[i], -half_turn_rad, half_turn_rad)) return TWD_ERROR_RANGE;

    if (!twd_within(acceleration_m_s2, TWD_NUM(0), TWD_NUM(20))) return TWD_ERROR_RANGE;
    const twd_num norm =
        twd_mul(direction[0], direction[0]) + twd_mul(direction[1], direction[1]) + twd_mul(direction[2], direction[2]);
    if (!twd_within(norm, TWD_NUM(0.999), TWD_NUM(1.001))) return TWD_ERROR_RANGE;
    return TWD_OK;
}

static struct twd_gravity_joint weigh(const struct twd_chain_joint *joint, twd_num acceleration_m_s2)
{
    struct twd_gravity_joint weighed;
    weighed.weight_n = twd_mul(joint->mass_kg, acceleration_m_s2);
    for (int axis = 0; axis < 3; axis++) {
        weighed.origin_m[axis] = joint->origin_m[axis];
        weighed.moment_nm[axis] = twd_mul(weighed.weight_n, joint->centre_of_mass_m[axis]);
        for (int column = 0; column < 3; column++)
            weighed.rotation[axis][column] = joint->rotation[axis][column];
    }
    return weighed;
}

enum twd_error twd_gravity_init(struct twd_gravity *gravity, const struct twd_chain *chain, uint8_t moving,
                                const twd_num *held_angle_rad, twd_num acceleration_m_s2, const twd_num direction[3])
{
    if (chain->joints < 1 || chain->joints > TWD_MAX_CHAIN_JOINTS) return TWD_ERROR_CHAIN;
    if (moving < 1 || moving > chain->joints) return TWD_ERROR_CHAIN;
    enum twd_error error = check_chain(chain);
    if (error == TWD_OK)
        error = check_gravity(held_angle_rad, (uint8_t)(chain->joints - moving), acceleration_m_s2, direction);
    if (error != TWD_OK) return error;

    gravity->moving = moving;
    for (int axis = 0; axis < 3; axis++)
        gravity->direction[axis] = direction[axis];
    for (uint8_t i = 0; i < chain->joints; i++)
        gravity->joint[i] = weigh(&chain->joint[i], acceleration_m_s2);

    /* From the tip inwards, each held link becomes part of its parent. */
    for (uint8_t i = chain->joints; i-- > moving;) {
        const struct twd_gravity_joint *const held = &gravity->joint[i];
        struct twd_gravity_joint *const parent = &gravity->joint[i - 1];
        const twd_phase angle = twd_phase_from_angle(held_angle_rad[i - moving]);
        add_to_parent(held, twd_sin(angle), twd_cos(angle), held->weight_n, held->moment_nm, parent->moment_nm);
        parent->weight_n += held->weight_n;
    }
    return TWD_OK;
}

void twd_gravity_torque(const struct twd_gravity *gravity, const twd_num *angle_rad, twd_num *torque_nm)
{
    twd_num sine[TWD_MAX_CHAIN_JOINTS];
    twd_num cosine[TWD_MAX_CHAIN_JOINTS];
    twd_num direction[TWD_MAX_CHAIN_JOINTS][3]; /* of gravity, in each link's frame */

    for (uint8_t i = 0; i < gravity->moving; i++) {
        const twd_phase angle = twd_phase_from_angle(angle_rad[i]);
        sine[i] = twd_sin(angle);
        cosine[i] = twd_cos(angle);
        to_link(&gravity->joint[i], sine[i], cosine[i], i == 0 ? gravity->direction : direction[i - 1], direction[i]);
    }

    twd_num moment_nm[3] = {TWD_NUM(0), TWD_NUM(0), TWD_NUM(0)}; /* of link i and all beyond it, in its frame */
    twd_num weight_n = TWD_NUM(0);                               /* of the same */
    for (uint8_t i = gravity->moving; i-- > 0;) {
        twd_num sum_nm[3] = {gravity->joint[i].moment_nm[0], gravity->joint[i].moment_nm[1],
                             gravity->joint[i].moment_nm[2]};
        if (i + 1 < gravity->moving)
            add_to_parent(&gravity->joint[i + 1], sine[i + 1], cosine[i + 1], weight_n, moment_nm, sum_nm);
        for (int axis = 0; axis < 3; axis++)
            moment_nm[axis] = sum_nm[axis];
        weight_n += gravity->joint[i].weight_n;
        /* The weight turns the joint by (moment x direction) about z; holding takes the opposite. */
        torque_nm[i] = twd_mul(moment_nm[1], direction[i][0]) - twd_mul(moment_nm[0], direction[i][1]);
    }
}
