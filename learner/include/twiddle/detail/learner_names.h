/* detail/learner_names.h: the learner's external symbols, each as its build names it (build.h).
 *
 * A header that declares one includes this; a test finds a symbol that is missing here. */
#ifndef TWIDDLE_DETAIL_LEARNER_NAMES_H
#define TWIDDLE_DETAIL_LEARNER_NAMES_H

#include <twiddle/detail/build.h>

/* actor.h */
#define twd_actor_init TWD_BUILD_NAME(twd_actor_init)
#define twd_actor_unit TWD_BUILD_NAME(twd_actor_unit)
#define twd_actor_activate TWD_BUILD_NAME(twd_actor_activate)
#define twd_actor_explore TWD_BUILD_NAME(twd_actor_explore)
#define twd_actor_learn TWD_BUILD_NAME(twd_actor_learn)

/* critic.h */
#define twd_critic_init TWD_BUILD_NAME(twd_critic_init)
#define twd_critic_value TWD_BUILD_NAME(twd_critic_value)
#define twd_critic_learn TWD_BUILD_NAME(twd_critic_learn)

/* input_map.h */
#define twd_input_map TWD_BUILD_NAME(twd_input_map)

/* learner.h */
#define twd_noise_half_range TWD_BUILD_NAME(twd_noise_half_range)
#define twd_learner_init TWD_BUILD_NAME(twd_learner_init)
#define twd_learner_restore TWD_BUILD_NAME(twd_learner_restore)
#define twd_learner_act TWD_BUILD_NAME(twd_learner_act)
#define twd_learner_learn TWD_BUILD_NAME(twd_learner_learn)
#define twd_learner_policy TWD_BUILD_NAME(twd_learner_policy)

/* random.h */
#define twd_random_seed TWD_BUILD_NAME(twd_random_seed)
#define twd_random_next TWD_BUILD_NAME(twd_random_next)
#define twd_random_symmetric TWD_BUILD_NAME(twd_random_symmetric)

#endif
