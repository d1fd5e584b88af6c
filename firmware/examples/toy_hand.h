/* toy_hand.h: what stands for a hand in the examples, behind the two functions that a board's motors and encoders have.
 *
 * Four joints without weight or friction, each of 40 g cm2, that only their torques move; encoders that know angles,
 * from which velocities are made as firmware makes them. */
#ifndef TWIDDLE_EXAMPLES_TOY_HAND_H
#define TWIDDLE_EXAMPLES_TOY_HAND_H

#include <twiddle/icub_right_hand.h>

/* The hand; all zero is straight and at rest. */
struct toy_hand {
    twd_num angle_rad[TWD_ICUB_JOINTS];
    twd_num turned_rad[TWD_ICUB_JOINTS]; /* in the last 2 ms */
};

/* Read the encoders: angles, rad, and velocities, rad/s. */
void toy_hand_measure(const struct toy_hand *hand, twd_num *angle_rad, twd_rate *velocity_rad_s);

/* Give the motors their torques, N m, for the next 2 ms. */
void toy_hand_drive(struct toy_hand *hand, const twd_num *torque_nm);

#endif
