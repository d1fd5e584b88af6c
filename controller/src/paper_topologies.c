#include <twiddle/cpg.h>

/* Joint order: FEI, AAI, FET, OT. Oscillators are numbered as in the paper's Fig. 3, from 0 here. */

static const struct twd_coupling cpg_c_coupling[] = {{0, 1}, {0, 2}, {2, 3}};
static const uint8_t cpg_c_joint_oscillator[] = {0, 1, 2, 3};
/* The hand starts with all joints at 0 rad, and the range of AAI is symmetric: its 0 is the middle. */
static const twd_num cpg_c_initial_centre[] = {TWD_NUM(0), TWD_NUM(0.5), TWD_NUM(0), TWD_NUM(0)};

const struct twd_topology twd_cpg_c = {
    .name = "cpg-c",
    .oscillators = 4,
    .couplings = 3,
    .joints = 4,
    .chooses_frequency = true,
    .coupling = cpg_c_coupling,
    .joint_oscillator = cpg_c_joint_oscillator,
    .initial_centre = cpg_c_initial_centre,
};

static const struct twd_coupling cpg_m_coupling[] = {{0, 1}};
static const uint8_t cpg_m_joint_oscillator[] = {0, 1, 0, 1};
static const twd_num cpg_m_initial_centre[] = {TWD_NUM(0), TWD_NUM(0)};

const struct twd_topology twd_cpg_m = {
    .name = "cpg-m",
    .oscillators = 2,
    .couplings = 1,
    .joints = 4,
    .chooses_frequency = false,
    .coupling = cpg_m_coupling,
    .joint_oscillator = cpg_m_joint_oscillator,
    .initial_centre = cpg_m_initial_centre,
};

static const uint8_t cpg_s_joint_oscillator[] = {0, 0, 0, 0};
static const twd_num cpg_s_initial_centre[] = {TWD_NUM(0)};

const struct twd_topology twd_cpg_s = {
    .name = "cpg-s",
    .oscillators = 1,
    .couplings = 0,
    .joints = 4,
    .chooses_frequency = false,
    .coupling = 0,
    .joint_oscillator = cpg_s_joint_oscillator,
    .initial_centre = cpg_s_initial_centre,
};
