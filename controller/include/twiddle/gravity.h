/* gravity.h: the torque that holds a serial finger chain against its weight, g(q) of the PD law (pd.h).
 *
 * A chain is a const table of joints, each turning about the z axis of its own frame, and of the link that follows
 * each. The first joints move; the rest are held at fixed angles and are merged into the last moving link at set-up. */
#ifndef TWIDDLE_GRAVITY_H
#define TWIDDLE_GRAVITY_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/error.h>
#include <twiddle/limits.h>
#include <twiddle/number.h>

TWD_BEGIN_DECLARATIONS

/* One joint and the link that it carries. */
struct twd_chain_joint {
    /* The joint's frame at angle 0, in the parent link's frame; rows of the matrix. */
    twd_num rotation[3][3];
    /* Its origin in the parent link's frame, m. */
    twd_num origin_m[3];
    /* The link's mass, kg. */
    twd_num mass_kg;
    /* In the link's frame, which is the turned joint frame, m. */
    twd_num centre_of_mass_m[3];
};

/* A finger: const, in flash. */
struct twd_chain {
    /* 1..TWD_MAX_CHAIN_JOINTS */
    uint8_t joints;
    /* [joints], from the palm outwards. */
    const struct twd_chain_joint *joint;
};

/* One moving joint and its link, ready for the tick. */
struct twd_gravity_joint {
    /* As in the table. */
    twd_num rotation[3][3];
    /* Weight times centre of mass, in the link's frame, N m; all links beyond it counted as lying in the next
     * joint's origin. */
    twd_num moment_nm[3];
};

/* A finger whose first `moving` joints move. */
struct twd_gravity {
    /* 1..joints of the chain. */
    uint8_t moving;
    /* Unit vector of gravity in the first joint's frame at angle 0. */
    twd_num direction[3];
    /* [moving] */
    struct twd_gravity_joint joint[TWD_MAX_CHAIN_JOINTS];
    /* If two joints move: the finger's potential energy in J is the sum of these, times 1, cos or sin of the first
     * angle (rows) and of the second (columns). */
    twd_num pair_energy_j[3][3];
};

/* Prepare `gravity` for `chain`: its first `moving` joints move, the others stay at `held_angle_rad` ([joints -
 * moving]; may be null if all move). `acceleration_m_s2` is gravity's size (0..20), `direction` its unit vector in the
 * chain's base frame. Errors: a null pointer; a chain too long; a number outside its range, a rotation that is none,
 * and a chain that weighs more than 1e6 N or whose links' moments sum to more than TWD_LARGEST_MOMENT_NM (fixed: 8 N
 * and 4 N m). */
enum twd_error twd_gravity_init(struct twd_gravity *gravity, const struct twd_chain *chain, uint8_t moving,
                                const twd_num *held_angle_rad, twd_wide acceleration_m_s2, const twd_num direction[3]);

/* Torques in N m, [moving], that hold the finger still at the joint angles `angle_rad` ([moving], each in [-pi,
 * pi]). */
void twd_gravity_torque(const struct twd_gravity *gravity, const twd_num *angle_rad, twd_num *torque_nm);

TWD_END_DECLARATIONS

#endif
