#include <twiddle/gravity.h>

#include <twiddle/phase.h>

#include "checks.h"

static twd_num dot(const twd_num a[3], const twd_num b[3])
{
    return twd_mul(a[0], b[0]) + twd_mul(a[1], b[1]) + twd_mul(a[2], b[2]);
}

/* R v, out of a joint's frame at angle 0 into its parent's. */
static void to_parent(const twd_num rotation[3][3], const twd_num v[3], twd_num out[3])
{
    for (int row = 0; row < 3; row++)
        out[row] = dot(rotation[row], v);
}

/* R^T v, out of a parent's frame into a joint's at angle 0. */
static void from_parent(const twd_num rotation[3][3], const twd_num v[3], twd_num out[3])
{
    for (int column = 0; column < 3; column++)
        out[column] = twd_mul(rotation[0][column], v[0]) + twd_mul(rotation[1][column], v[1]) +
                      twd_mul(rotation[2][column], v[2]);
}

/* Turn v about z by the angle of this sine and cosine. */
static void turn(twd_num sine, twd_num cosine, const twd_num v[3], twd_num out[3])
{
    out[0] = twd_mul(cosine, v[0]) - twd_mul(sine, v[1]);
    out[1] = twd_mul(sine, v[0]) + twd_mul(cosine, v[1]);
    out[2] = v[2];
}

/* Whether the components are small enough for a product, and the length is 1. */
static bool is_unit_vector(const twd_num v[3])
{
    for (int axis = 0; axis < 3; axis++)
        if (!twd_within(v[axis], TWD_NUM(-1.001), TWD_NUM(1.001))) return false;
    return twd_within(dot(v, v), TWD_NUM(0.999), TWD_NUM(1.001));
}

/* Whether the rows are unit vectors, each at right angles to the others: such a matrix makes no vector longer. */
static bool is_rotation(const twd_num rotation[3][3])
{
    for (int row = 0; row < 3; row++)
        if (!is_unit_vector(rotation[row])) return false;
    for (int row = 0; row < 3; row++)
        if (!twd_within(dot(rotation[row], rotation[(row + 1) % 3]), TWD_NUM(-0.001), TWD_NUM(0.001))) return false;
    return true;
}

static enum twd_error check_chain(const struct twd_chain *chain)
{
    for (uint8_t i = 0; i < chain->joints; i++) {
        const struct twd_chain_joint *const joint = &chain->joint[i];
        if (!(joint->mass_kg >= TWD_NUM(0)) || !twd_is_usable(joint->mass_kg)) return TWD_ERROR_RANGE;
        for (int axis = 0; axis < 3; axis++)
            if (!twd_is_usable(joint->origin_m[axis]) || !twd_is_usable(joint->centre_of_mass_m[axis]))
                return TWD_ERROR_RANGE;
        if (!is_rotation(joint->rotation)) return TWD_ERROR_RANGE;
    }
    return TWD_OK;
}

static enum twd_error check_gravity(const twd_num *held_angle_rad, uint8_t held, twd_wide acceleration_m_s2,
                                    const twd_num direction[3])
{
    const twd_num half_turn_rad = TWD_NUM_CONSTANT(3.14159265358979324, 843314857);
    if (!direction || (!held_angle_rad && held > 0)) return TWD_ERROR_NULL;
    for (uint8_t i = 0; i < held; i++)
        if (!twd_within(held_angle_rad[i], -half_turn_rad, half_turn_rad)) return TWD_ERROR_RANGE;

    if (!(acceleration_m_s2 >= TWD_WIDE(0) && acceleration_m_s2 <= TWD_WIDE(20))) return TWD_ERROR_RANGE;
    return is_unit_vector(direction) ? TWD_OK : TWD_ERROR_RANGE;
}

/* The weight of all links; at the end of its range if it lies beyond. */
static twd_num weight_of_chain(const struct twd_chain *chain, twd_wide acceleration_m_s2)
{
    twd_num weight_n = TWD_NUM(0);
    for (uint8_t i = 0; i < chain->joints; i++)
        weight_n = twd_add_saturated(weight_n, twd_num_mul_wide(chain->joint[i].mass_kg, acceleration_m_s2));
    return weight_n;
}

/* The link on its own, as if nothing were beyond it. */
static struct twd_gravity_joint weigh(const struct twd_chain_joint *joint, twd_wide acceleration_m_s2)
{
    const twd_num weight_n = twd_num_mul_wide(joint->mass_kg, acceleration_m_s2);
    struct twd_gravity_joint weighed;
    for (int axis = 0; axis < 3; axis++) {
        weighed.moment_nm[axis] = twd_mul_saturated(weight_n, joint->centre_of_mass_m[axis]);
        for (int column = 0; column < 3; column++)
            weighed.rotation[axis][column] = joint->rotation[axis][column];
    }
    return weighed;
}

/* No torque of the first `links` links is larger than this: the sum of their moments along all axes. */
static twd_num largest_moment(const struct twd_gravity_joint *joint, uint8_t links)
{
    twd_num sum_nm = TWD_NUM(0);
    for (uint8_t i = 0; i < links; i++) {
        for (int axis = 0; axis < 3; axis++) {
            const twd_num moment_nm = joint[i].moment_nm[axis];
            sum_nm = twd_add_saturated(sum_nm, moment_nm < TWD_NUM(0) ? -moment_nm : moment_nm);
        }
    }
    return sum_nm;
}

/* Add the moment of a link held at `angle_rad` to its parent's. */
static void merge(const struct twd_gravity_joint *held, twd_num angle_rad, twd_num parent_moment_nm[3])
{
    twd_num sine, cosine, turned_nm[3], moment_nm[3];
    twd_sine_cosine_of_angle(angle_rad, &sine, &cosine);
    turn(sine, cosine, held->moment_nm, turned_nm);
    to_parent(held->rotation, turned_nm, moment_nm);
    for (int axis = 0; axis < 3; axis++)
        parent_moment_nm[axis] += moment_nm[axis];
}

/* v in a frame that turns by q about z, as a sum: part[0] + cos(q) part[1] + sin(q) part[2]. */
static void split_by_angle(const twd_num v[3], twd_num part[3][3])
{
    const twd_num parts[3][3] = {{TWD_NUM(0), TWD_NUM(0), v[2]}, {v[0], v[1], TWD_NUM(0)}, {v[1], -v[0], TWD_NUM(0)}};
    for (int i = 0; i < 3; i++)
        for (int axis = 0; axis < 3; axis++)
            part[i][axis] = parts[i][axis];
}

/* The energy of a link is minus its moment along gravity's direction, and the direction is split by both angles. */
static void find_pair_energy(struct twd_gravity *gravity)
{
    const struct twd_gravity_joint *const first = &gravity->joint[0];
    const struct twd_gravity_joint *const second = &gravity->joint[1];
    twd_num in_first[3][3];
    split_by_angle(gravity->direction, in_first);
    for (int i = 0; i < 3; i++) {
        twd_num direction[3], in_second[3][3];
        from_parent(second->rotation, in_first[i], direction);
        split_by_angle(direction, in_second);
        for (int j = 0; j < 3; j++)
            gravity->pair_energy_j[i][j] = -dot(second->moment_nm, in_second[j]);
        gravity->pair_energy_j[i][0] -= dot(first->moment_nm, in_first[i]);
    }
}

enum twd_error twd_gravity_init(struct twd_gravity *gravity, const struct twd_chain *chain, uint8_t moving,
                                const twd_num *held_angle_rad, twd_wide acceleration_m_s2, const twd_num direction[3])
{
    if (!chain || !chain->joint) return TWD_ERROR_NULL;
    if (chain->joints < 1 || chain->joints > TWD_MAX_CHAIN_JOINTS) return TWD_ERROR_CHAIN;
    if (moving < 1 || moving > chain->joints) return TWD_ERROR_CHAIN;
    enum twd_error error = check_chain(chain);
    if (error == TWD_OK)
        error = check_gravity(held_angle_rad, (uint8_t)(chain->joints - moving), acceleration_m_s2, direction);
    if (error != TWD_OK) return error;
    if (!twd_is_usable(weight_of_chain(chain, acceleration_m_s2))) return TWD_ERROR_RANGE;

    struct twd_gravity made;
    made.moving = moving;
    from_parent(chain->joint[0].rotation, direction, made.direction);
    for (uint8_t i = 0; i < chain->joints; i++)
        made.joint[i] = weigh(&chain->joint[i], acceleration_m_s2);

    /* From the tip inwards, each link hangs its weight and all beyond it on its parent; a held one is merged whole. */
    twd_num weight_n = TWD_NUM(0);
    for (uint8_t i = chain->joints; i-- > 1;) {
        twd_num *const parent_moment_nm = made.joint[i - 1].moment_nm;
        weight_n += twd_num_mul_wide(chain->joint[i].mass_kg, acceleration_m_s2);
        for (int axis = 0; axis < 3; axis++)
            parent_moment_nm[axis] =
                twd_add_saturated(parent_moment_nm[axis], twd_mul_saturated(weight_n, chain->joint[i].origin_m[axis]));
        if (largest_moment(made.joint, chain->joints) > TWD_LARGEST_MOMENT_NM) return TWD_ERROR_RANGE;
        if (i >= moving) merge(&made.joint[i], held_angle_rad[i - moving], parent_moment_nm);
    }
    if (largest_moment(made.joint, moving) > TWD_LARGEST_MOMENT_NM) return TWD_ERROR_RANGE;
    if (moving == 2) find_pair_energy(&made);
    *gravity = made;
    return TWD_OK;
}

/* The slopes of the pair's energy: cos' = -sin, sin' = cos. */
static void pair_torque(const twd_num energy_j[3][3], const twd_num angle_rad[2], twd_num torque_nm[2])
{
    twd_num sine[2], cosine[2];
    twd_sine_cosine_of_angle(angle_rad[0], &sine[0], &cosine[0]);
    twd_sine_cosine_of_angle(angle_rad[1], &sine[1], &cosine[1]);

    const twd_num of_first_cosine =
        energy_j[1][0] + twd_mul(energy_j[1][1], cosine[1]) + twd_mul(energy_j[1][2], sine[1]);
    const twd_num of_first_sine =
        energy_j[2][0] + twd_mul(energy_j[2][1], cosine[1]) + twd_mul(energy_j[2][2], sine[1]);
    torque_nm[0] = twd_mul(of_first_sine, cosine[0]) - twd_mul(of_first_cosine, sine[0]);

    const twd_num of_second_cosine =
        energy_j[0][1] + twd_mul(energy_j[1][1], cosine[0]) + twd_mul(energy_j[2][1], sine[0]);
    const twd_num of_second_sine =
        energy_j[0][2] + twd_mul(energy_j[1][2], cosine[0]) + twd_mul(energy_j[2][2], sine[0]);
    torque_nm[1] = twd_mul(of_second_sine, cosine[1]) - twd_mul(of_second_cosine, sine[1]);
}

/* Gravity's direction is handed from link to link outwards, then the moments of the links inwards. */
static void chain_torque(const struct twd_gravity *gravity, const twd_num *angle_rad, twd_num *torque_nm)
{
    twd_num sine[TWD_MAX_CHAIN_JOINTS];
    twd_num cosine[TWD_MAX_CHAIN_JOINTS];
    for (uint8_t i = 0; i < gravity->moving; i++)
        twd_sine_cosine_of_angle(angle_rad[i], &sine[i], &cosine[i]);

    twd_num direction[TWD_MAX_CHAIN_JOINTS][3]; /* of gravity, in each joint's frame at angle 0 */
    for (int axis = 0; axis < 3; axis++)
        direction[0][axis] = gravity->direction[axis];
    for (uint8_t i = 1; i < gravity->moving; i++) {
        twd_num in_parent[3];
        turn(-sine[i - 1], cosine[i - 1], direction[i - 1], in_parent);
        from_parent(gravity->joint[i].rotation, in_parent, direction[i]);
    }

    twd_num beyond_nm[3] = {TWD_NUM(0), TWD_NUM(0), TWD_NUM(0)}; /* moment of the links beyond link i, in its frame */
    for (uint8_t i = gravity->moving; i-- > 0;) {
        const struct twd_gravity_joint *const joint = &gravity->joint[i];
        const twd_num sum_nm[3] = {joint->moment_nm[0] + beyond_nm[0], joint->moment_nm[1] + beyond_nm[1],
                                   joint->moment_nm[2] + beyond_nm[2]};
        twd_num moment_nm[3]; /* the sum, in the joint's frame at angle 0 */
        turn(sine[i], cosine[i], sum_nm, moment_nm);
        /* The weight turns the joint by (moment x direction) about z; holding takes the opposite. */
        torque_nm[i] = twd_mul(moment_nm[1], direction[i][0]) - twd_mul(moment_nm[0], direction[i][1]);
        to_parent(joint->rotation, moment_nm, beyond_nm);
    }
}

void twd_gravity_torque(const struct twd_gravity *gravity, const twd_num *angle_rad, twd_num *torque_nm)
{
    if (gravity->moving == 2)
        pair_torque(gravity->pair_energy_j, angle_rad, torque_nm);
    else
        chain_torque(gravity, angle_rad, torque_nm);
}
