/* transfer.h: the payloads of messages (messages.h), written and read.
 *
 * Each function describes one message for both directions, so that the two ends cannot disagree. */
#ifndef TWIDDLE_AGENT_TRANSFER_H
#define TWIDDLE_AGENT_TRANSFER_H

#include "agent/agent_names.h"
#include "agent/frame.h"
#include "agent/messages.h"

#include <twiddle/controller.h>
#include <twiddle/learner.h>

#include <stdbool.h>

TWD_BEGIN_DECLARATIONS

/* The format of this build's numbers. */
#if defined(TWD_NUMBER_FIXED)
#define TWD_NUMBERS_HERE TWD_NUMBERS_FIXED
#elif defined(TWD_NUMBER_FLOAT)
#define TWD_NUMBERS_HERE TWD_NUMBERS_FLOAT
#else
#error "numbers must have 32 bits to go over the link: build with TWD_NUMBER_FIXED or TWD_NUMBER_FLOAT"
#endif

/* Models by their number on the link; a null pointer for a number that is none. */
#define TWD_MODELS 4U
const struct twd_model *twd_model_of_number(uint32_t number);

/* A payload being written or read, word after word. */
struct twd_transfer {
    struct twd_frame *frame;
    /* Bytes done. */
    uint16_t at;
    /* Into the frame, or out of it. */
    bool writing;
    /* No room, no bytes, or a field beyond what it may be: what was read is not to be used. */
    bool failed;
};

/* Start to write the payload of `frame`. Its type and sequence number are the caller's. */
struct twd_transfer twd_transfer_to(struct twd_frame *frame);

/* Start to read the payload of `frame`, which stays as it is. */
struct twd_transfer twd_transfer_from(struct twd_frame *frame);

/* Whether all went well and, when reading, the whole payload was read. When writing, sets the frame's length. */
bool twd_transfer_end(struct twd_transfer *transfer);

/* `count` objects of 32 bits: whole numbers, phases, or the library's numbers. Read into the objects, or written from
 * them. */
void twd_transfer_words(struct twd_transfer *transfer, void *words, size_t count);

/* Who a chip is: the answer to TWD_REQUEST_HELLO. */
struct twd_hello {
    /* TWD_PROTOCOL_VERSION */
    uint32_t protocol;
    /* enum twd_numbers. */
    uint32_t numbers;
    /* TWD_MAX_JOINTS of the chip's build, and so on. */
    uint32_t joints;
    uint32_t fingers;
    uint32_t units;
    uint32_t inputs;
};
void twd_transfer_hello(struct twd_transfer *transfer, struct twd_hello *hello);

/* A controller's configuration, its model by number, but for joints and fingers, which follow one by one. */
void twd_transfer_controller(struct twd_transfer *transfer, struct twd_controller_config *config);

/* A joint or a finger and its place in the controller's configuration. */
void twd_transfer_joint(struct twd_transfer *transfer, uint8_t *index, struct twd_joint *joint);
void twd_transfer_finger(struct twd_transfer *transfer, uint8_t *index, struct twd_finger *finger);

/* The learner's configuration. */
void twd_transfer_learner(struct twd_transfer *transfer, struct twd_learner_config *config);

/* What a trial starts with: the answer to TWD_REQUEST_ACT, for a model of `cpgs` CPGs. */
struct twd_trial_start {
    /* E, the critic's estimate. */
    twd_wide value;
    /* Half-range in force. */
    twd_num noise;
    /* [cpgs]: s_k, in the model's order. */
    twd_num weight[TWD_MAX_CPGS];
};
void twd_transfer_trial_start(struct twd_transfer *transfer, struct twd_trial_start *start, uint8_t cpgs);

/* The learner's and the controller's counters: the answer to TWD_REQUEST_STATE. */
struct twd_agent_state {
    /* Learned from. */
    uint32_t trials;
    /* Of the generator of weights and noise. */
    struct twd_random random;
    /* Since TWD_REQUEST_BEGIN. */
    struct twd_saturations saturations;
};
void twd_transfer_state(struct twd_transfer *transfer, struct twd_agent_state *state);

TWD_END_DECLARATIONS

#endif
