/* checks.h: what the set-up functions require, shared by the modules of this library and not installed. */
#ifndef TWIDDLE_CHECKS_H
#define TWIDDLE_CHECKS_H

#include <twiddle/controller.h>
#include <twiddle/cpg.h>
#include <twiddle/error.h>

#define twd_check_cpgs TWD_BUILD_NAME(twd_check_cpgs)
#define twd_check_pd TWD_BUILD_NAME(twd_check_pd)
#define twd_check_config TWD_BUILD_NAME(twd_check_config)

/* Whether a CPG can be made of `topology`, [networks], and `config`. */
enum twd_error twd_check_cpgs(const struct twd_topology *const *topology, size_t networks,
                              const struct twd_cpg_config *config);

/* Whether `pd` is in range. */
enum twd_error twd_check_pd(const struct twd_pd *pd);

/* Whether a controller can be made of `config`. */
enum twd_error twd_check_config(const struct twd_controller_config *config);

#endif
