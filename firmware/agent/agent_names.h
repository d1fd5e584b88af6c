/* agent_names.h: the external symbols of the link's chip end, each as its build names it (twiddle/detail/build.h). */
#ifndef TWIDDLE_AGENT_AGENT_NAMES_H
#define TWIDDLE_AGENT_AGENT_NAMES_H

#include <twiddle/detail/build.h>

/* agent_server.h */
#define twd_agent_server_start TWD_BUILD_NAME(twd_agent_server_start)
#define twd_agent_server_answer TWD_BUILD_NAME(twd_agent_server_answer)
#define twd_agent_server_run TWD_BUILD_NAME(twd_agent_server_run)

/* transfer.h */
#define twd_model_of_number TWD_BUILD_NAME(twd_model_of_number)
#define twd_transfer_to TWD_BUILD_NAME(twd_transfer_to)
#define twd_transfer_from TWD_BUILD_NAME(twd_transfer_from)
#define twd_transfer_end TWD_BUILD_NAME(twd_transfer_end)
#define twd_transfer_words TWD_BUILD_NAME(twd_transfer_words)
#define twd_transfer_hello TWD_BUILD_NAME(twd_transfer_hello)
#define twd_transfer_controller TWD_BUILD_NAME(twd_transfer_controller)
#define twd_transfer_joint TWD_BUILD_NAME(twd_transfer_joint)
#define twd_transfer_finger TWD_BUILD_NAME(twd_transfer_finger)
#define twd_transfer_learner TWD_BUILD_NAME(twd_transfer_learner)
#define twd_transfer_trial_start TWD_BUILD_NAME(twd_transfer_trial_start)
#define twd_transfer_state TWD_BUILD_NAME(twd_transfer_state)

#endif
