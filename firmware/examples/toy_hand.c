#include "toy_hand.h"

#include <stddef.h>

#define PERIOD_S TWD_SMALL_CONSTANT(0.002, 34359738)

/* What a torque adds to the way of a period, rad for 1 N m: (2 ms)^2 / 4e-5 kg m2. */
#define WAY_PER_TORQUE TWD_NUM_CONSTANT(0.1, 26843546)

void toy_hand_measure(const struct toy_hand *hand, twd_num *angle_rad, twd_rate *velocity_rad_s)
{
    for (size_t j = 0; j < TWD_ICUB_JOINTS; j++) {
        angle_rad[j] = hand->angle_rad[j];
        velocity_rad_s[j] = twd_rate_div_small(hand->turned_rad[j], PERIOD_S);
    }
}

void toy_hand_drive(struct toy_hand *hand, const twd_num *torque_nm)
{
    for (size_t j = 0; j < TWD_ICUB_JOINTS; j++) {
        hand->turned_rad[j] += twd_mul(torque_nm[j], WAY_PER_TORQUE);
        hand->angle_rad[j] += hand->turned_rad[j];
    }
}
