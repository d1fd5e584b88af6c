/* icub_setup.h: controller and learner of the iCub hand for CPG-H with centre, as the set-up `paper`
 * (experiments/setups) makes them.
 *
 * A board reads no TOML, so the values are constants here; a test holds them to the set-up's files. */
#ifndef TWIDDLE_FIRMWARE_ICUB_SETUP_H
#define TWIDDLE_FIRMWARE_ICUB_SETUP_H

#include <twiddle/controller.h>
#include <twiddle/input_map.h>
#include <twiddle/learner.h>

/* Parameters of a trial. */
enum { ICUB_PARAMETERS = 22 };

/* Write the controller's configuration. Returns the first error of the library, whose constants then do not fit its
 * build. */
enum twd_error icub_controller_config(struct twd_controller_config *config);

/* The learner's configuration for a training of `trials` trials. */
struct twd_learner_config icub_learner_config(uint32_t trials, uint64_t seed);

/* What the learner sees of the small sphere, [TWD_INPUTS]. */
void icub_small_sphere(twd_num *input);

#endif
