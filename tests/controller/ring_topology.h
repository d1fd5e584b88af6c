/* ring_topology.h: a user-defined network for the tests, six oscillators in a ring, one a joint, as for six legs. */
#ifndef TWIDDLE_RING_TOPOLOGY_H
#define TWIDDLE_RING_TOPOLOGY_H

#include <twiddle/cpg.h>

#define RING_OSCILLATORS 6

static const struct twd_coupling ring_coupling[] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};
static const uint8_t ring_joint_oscillator[] = {0, 1, 2, 3, 4, 5};
static const twd_num ring_initial_centre[] = {TWD_NUM(0.5), TWD_NUM(0.5), TWD_NUM(0.5),
                                              TWD_NUM(0.5), TWD_NUM(0.5), TWD_NUM(0.5)};

static const struct twd_topology ring = {
    .name = "ring",
    .oscillators = RING_OSCILLATORS,
    .couplings = 6,
    .joints = RING_OSCILLATORS,
    .chooses_frequency = true,
    .coupling = ring_coupling,
    .joint_oscillator = ring_joint_oscillator,
    .initial_centre = ring_initial_centre,
};

#endif
