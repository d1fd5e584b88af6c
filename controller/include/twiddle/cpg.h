/* cpg.h: a central pattern generator, a network of coupled phase oscillators described by a const table.
 *
 *     theta_i' = 2 pi nu + sum_j r_j w sin(theta_j - theta_i - phi_ij), w = 1
 *
 * (Ciancio et al. 2011, eqs. 9 and 12); amplitudes and centres: filter.h; one oscillator's output: oscillator.h. A
 * coupling acts both ways and, with phi_ji = -phi_ij, costs one sine. The phase rate of a tick is extrapolated from
 * this tick and the last (second-order Adams-Bashforth). A new network is a new `const struct twd_topology`, no
 * code. */
#ifndef TWIDDLE_CPG_H
#define TWIDDLE_CPG_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/detail/four.h>
#include <twiddle/error.h>
#include <twiddle/limits.h>
#include <twiddle/oscillator.h>

#include <stddef.h>

TWD_BEGIN_DECLARATIONS

/* One coupling. Its parameter phi is phi_ij of `first` i and `second` j: with phi_ji = -phi_ij, the phase by which
 * `second` leads `first` when the network has settled. */
struct twd_coupling {
    /* Oscillator, from 0. */
    uint8_t first;
    /* Another oscillator. */
    uint8_t second;
};

/* A network's structure: const, in flash. Pointers refer to arrays as long as the counts say. */
struct twd_topology {
    /* For people, e.g. "cpg-c". */
    const char *name;
    /* 1..TWD_MAX_OSCILLATORS */
    uint8_t oscillators;
    /* 0..TWD_MAX_COUPLINGS */
    uint8_t couplings;
    /* 1..TWD_MAX_JOINTS */
    uint8_t joints;
    /* Its first parameter is nu, used by all CPGs of the controller. */
    bool chooses_frequency;
    /* [couplings] */
    const struct twd_coupling *coupling;
    /* [joints]: which oscillator drives each joint. */
    const uint8_t *joint_oscillator;
    /* [oscillators]: c at t = 0, of the joint's range, 0..1. */
    const twd_num *initial_centre;
};

/* The paper's networks (its Fig. 3), over the joints FEI, AAI, FET, OT in this order. */

/* 4 oscillators, one a joint; couplings 1-2, 1-3, 3-4; chooses nu. */
extern const struct twd_topology twd_cpg_c;

/* 2 oscillators: FEI and FET, AAI and OT; coupling 1-2. */
extern const struct twd_topology twd_cpg_m;

/* 1 oscillator for all four joints. */
extern const struct twd_topology twd_cpg_s;

/* phi_ji, the lag with which a coupling's second oscillator is pulled by its first; the paper does not say. */
enum twd_return_lag {
    /* -phi_ij: both ends ask for the same difference. */
    TWD_RETURN_LAG_NEGATED = 0,
    /* +phi_ij: equal oscillators settle at a difference of 0 or half a turn, whatever phi. */
    TWD_RETURN_LAG_EQUAL = 1
};

/* Where the centres c start a trial; the paper does not say. */
enum twd_centre_start {
    /* At the topology's initial_centre, where the hand starts. */
    TWD_CENTRE_START_AT_TOPOLOGY = 0,
    /* At the lower end of each joint's range. */
    TWD_CENTRE_START_AT_ZERO = 1,
    /* At C: the centre is constant through the trial. */
    TWD_CENTRE_START_AT_TARGET = 2
};

/* What a network is made with, beside its structure. */
struct twd_cpg_config {
    /* Output equation: oscillator.h. */
    bool with_centre;
    /* (0, 0.1] s */
    twd_small tick_s;
    /* a, 1/s; above 0, its product with the tick at most TWD_LARGEST_RATE_TIMES_TICK. */
    twd_rate amplitude_rate_per_s;
    /* b, 1/s; the same range. */
    twd_rate centre_rate_per_s;
    enum twd_return_lag return_lag;
    enum twd_centre_start centre_start;
};

/* What drives a network through one trial, in physical units. */
struct twd_cpg_drive {
    /* nu, of every oscillator. */
    twd_num frequency_hz;
    /* R, of the joint's range. */
    twd_num amplitude[TWD_MAX_OSCILLATORS];
    /* C, of the joint's range; not read by a network without centre. */
    twd_num centre[TWD_MAX_OSCILLATORS];
    /* phi, turns (2^32 = one). */
    twd_phase phase_lag[TWD_MAX_COUPLINGS];
};

/* A coupling of running oscillators. */
struct twd_running_coupling {
    /* phi of this trial and a quarter turn, which makes a sine of a cosine, turns (2^32 = one). */
    twd_phase lag_and_quarter;
    /* Where the oscillators at its ends stand among those of all networks, bytes. */
    uint16_t first;
    uint16_t second;
};

/* One or several running networks, whose oscillators stand in one array, one network's after another's. All fields are
 * private to the module but may be read. */
struct twd_cpg {
    struct twd_cpg_config config;
    /* a's transition. */
    struct twd_filter_step amplitude_step;
    /* b's transition. */
    struct twd_filter_step centre_step;
    /* From rad/s to the turns of a tick. */
    twd_turn_gain turn_gain;
    /* Turns a tick, from nu. */
    twd_phase intrinsic_advance;
    /* 1..TWD_MAX_CPGS */
    uint8_t networks;
    /* Of all networks. */
    uint8_t oscillators;
    /* Where the oscillators in use end, bytes. */
    uint16_t oscillators_end;
    /* Where the couplings in use end, bytes. */
    uint16_t couplings_end;
    /* Of all networks. */
    uint8_t couplings;
    /* [networks] */
    const struct twd_topology *topology[TWD_MAX_CPGS];
    /* [couplings] */
    struct twd_running_coupling coupling[TWD_MAX_COUPLINGS];
    /* [oscillators]: state. */
    struct twd_oscillator oscillator[TWD_MAX_OSCILLATORS];
#if TWD_FOUR_AT_ONCE
    struct twd_four_filters filters;
#endif
};

/* Make `cpg` one network of `topology`; copies `config`. Errors: a topology that does not hold together, a field
 * outside its range. */
enum twd_error twd_cpg_init(struct twd_cpg *cpg, const struct twd_topology *topology,
                            const struct twd_cpg_config *config);

/* Make `cpg` several networks, of `topology`, [networks], which share `config` and a frequency but no coupling. Errors:
 * as above, and more networks, oscillators or couplings together than the arrays hold. */
enum twd_error twd_cpg_init_several(struct twd_cpg *cpg, const struct twd_topology *const *topology, size_t networks,
                                    const struct twd_cpg_config *config);

/* Start a trial: amplitudes and velocities 0, centres as centre_start says, phases as given ([oscillators] of all
 * networks, turns). `drive` is [networks]; the first one's frequency counts for all. */
void twd_cpg_start(struct twd_cpg *cpg, const struct twd_cpg_drive *drive, const twd_phase *initial_phase);

/* The phases at which every oscillator already has its desired lag: the first at 0, then along the couplings in the
 * table's order, each placing an oscillator that has none yet (again from the table's start while that places more). An
 * oscillator that no coupling reaches starts at 0 in its turn. `phase` is [oscillators]. */
void twd_cpg_phases_at_lag(const struct twd_topology *topology, const twd_phase *phase_lag, twd_phase *phase);

/* Advance by one tick. */
void twd_cpg_tick(struct twd_cpg *cpg);

/* Output of oscillator `index`, of the joint's range (not saturated). */
twd_num twd_cpg_output(const struct twd_cpg *cpg, uint8_t index);

TWD_END_DECLARATIONS

#endif
