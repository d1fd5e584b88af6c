/* detail/controller_names.h: the controller's external symbols, each as its build names it (build.h).
 *
 * A header that declares one includes this; a test finds a symbol that is missing here. */
#ifndef TWIDDLE_DETAIL_CONTROLLER_NAMES_H
#define TWIDDLE_DETAIL_CONTROLLER_NAMES_H

#include <twiddle/detail/build.h>

/* controller.h */
#define twd_controller_init TWD_BUILD_NAME(twd_controller_init)
#define twd_controller_start TWD_BUILD_NAME(twd_controller_start)
#define twd_controller_tick TWD_BUILD_NAME(twd_controller_tick)
#define twd_controller_torque TWD_BUILD_NAME(twd_controller_torque)

/* cpg.h */
#define twd_cpg_c TWD_BUILD_NAME(twd_cpg_c)
#define twd_cpg_m TWD_BUILD_NAME(twd_cpg_m)
#define twd_cpg_s TWD_BUILD_NAME(twd_cpg_s)
#define twd_cpg_init TWD_BUILD_NAME(twd_cpg_init)
#define twd_cpg_init_several TWD_BUILD_NAME(twd_cpg_init_several)
#define twd_cpg_start TWD_BUILD_NAME(twd_cpg_start)
#define twd_cpg_phases_at_lag TWD_BUILD_NAME(twd_cpg_phases_at_lag)
#define twd_cpg_tick TWD_BUILD_NAME(twd_cpg_tick)
#define twd_cpg_output TWD_BUILD_NAME(twd_cpg_output)

/* elementary.h */
#define twd_exp_negative TWD_BUILD_NAME(twd_exp_negative)
#define twd_exp_negative_of_num TWD_BUILD_NAME(twd_exp_negative_of_num)
#define twd_sigmoid TWD_BUILD_NAME(twd_sigmoid)

/* error.h */
#define twd_error_text TWD_BUILD_NAME(twd_error_text)

/* filter.h */
#define twd_filter_step_make TWD_BUILD_NAME(twd_filter_step_make)

/* gate.h */
#define twd_gate_normalise TWD_BUILD_NAME(twd_gate_normalise)

/* gravity.h */
#define twd_gravity_init TWD_BUILD_NAME(twd_gravity_init)
#define twd_gravity_torque TWD_BUILD_NAME(twd_gravity_torque)

/* icub_right_hand.h */
#define twd_icub_joint_range TWD_BUILD_NAME(twd_icub_joint_range)
#define twd_icub_index TWD_BUILD_NAME(twd_icub_index)
#define twd_icub_thumb TWD_BUILD_NAME(twd_icub_thumb)

/* joint_range.h */
#define twd_joint_range_angle TWD_BUILD_NAME(twd_joint_range_angle)

/* model.h */
#define twd_model_c TWD_BUILD_NAME(twd_model_c)
#define twd_model_m TWD_BUILD_NAME(twd_model_m)
#define twd_model_s TWD_BUILD_NAME(twd_model_s)
#define twd_model_h TWD_BUILD_NAME(twd_model_h)
#define twd_model_parameters TWD_BUILD_NAME(twd_model_parameters)
#define twd_model_decode TWD_BUILD_NAME(twd_model_decode)

/* pd.h */
#define twd_pd_stable TWD_BUILD_NAME(twd_pd_stable)

/* phase.h, where it is not inline */
#define twd_cos TWD_BUILD_NAME(twd_cos)

/* setup.h */
#define twd_setup_config TWD_BUILD_NAME(twd_setup_config)

/* skill.h */
#define twd_skill_start TWD_BUILD_NAME(twd_skill_start)

#endif
