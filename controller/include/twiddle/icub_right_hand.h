/* icub_right_hand.h: the constants of the iCub right hand that the controller needs.
 *
 * The tables (src/icub_right_hand.c) are written from models/icub_right_hand.urdf by `make hand-tables`; a test
 * holds them to the URDF. Chains start in the `hand` frame, the URDF's root. */
#ifndef TWIDDLE_ICUB_RIGHT_HAND_H
#define TWIDDLE_ICUB_RIGHT_HAND_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/gravity.h>
#include <twiddle/joint_range.h>

TWD_BEGIN_DECLARATIONS

/* The four controlled joints, in the order of every joint array of this project. */
enum twd_icub_joint {
    TWD_ICUB_FEI = 0, /* flexion/extension of the index: index_1 */
    TWD_ICUB_AAI = 1, /* adduction/abduction of the index: index_0 */
    TWD_ICUB_FET = 2, /* flexion/extension of the thumb: thumb_1 */
    TWD_ICUB_OT = 3,  /* opposition of the thumb: thumb_0 */
    TWD_ICUB_JOINTS = 4
};

extern const struct twd_joint_range twd_icub_joint_range[TWD_ICUB_JOINTS];

/* index_0..index_3 and thumb_0..thumb_3: the first two of each are the controlled ones. */
extern const struct twd_chain twd_icub_index;
extern const struct twd_chain twd_icub_thumb;

TWD_END_DECLARATIONS

#endif
