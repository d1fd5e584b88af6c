/* messages.h: what the frames between a chip and the computer that drives it say (docs/PROTOCOL.md).
 *
 * The computer asks, the chip answers each request once; nobody speaks unasked. A payload is a row of 32-bit words, low
 * byte first: whole numbers, and the library's numbers as the build holds them (TWD_NUMBERS_HERE). Each function below
 * describes one message for both directions, so that the two ends cannot disagree. */
#ifndef TWIDDLE_AGENT_MESSAGES_H
#define TWIDDLE_AGENT_MESSAGES_H

#include "agent/frame.h"

#include <twiddle/agent.h>
#include <twiddle/controller.h>

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of the protocol as a whole: another number, another protocol. */
#define TWD_PROTOCOL_VERSION 1U

/* Types of requests. The answer's type is the request's with TWD_ANSWER added, or TWD_ANSWER_ERROR. */
enum twd_request {
    TWD_REQUEST_HELLO = 0x01,      /* who is there? Forgets all configuration */
    TWD_REQUEST_CONTROLLER = 0x02, /* twd_transfer_controller */
    TWD_REQUEST_JOINT = 0x03,      /* twd_transfer_joint */
    TWD_REQUEST_FINGER = 0x04,     /* twd_transfer_finger */
    TWD_REQUEST_LEARNER = 0x05,    /* twd_transfer_learner */
    TWD_REQUEST_BEGIN = 0x06,      /* make controller and learner of what was configured */
    TWD_REQUEST_ACT = 0x10,        /* start a trial */
    TWD_REQUEST_SUBSTEP = 0x11,    /* angles and velocities for torques */
    TWD_REQUEST_LEARN = 0x12,      /* end the trial with its reward */
    TWD_REQUEST_POLICY = 0x20,     /* parameters without noise */
    TWD_REQUEST_ACTOR = 0x21,      /* the weights of one unit of the actor */
    TWD_REQUEST_CRITIC = 0x22,     /* the weights of the critic */
    TWD_REQUEST_STATE = 0x23       /* trials, random state, saturations */
};

#define TWD_ANSWER 0x80U
#define TWD_ANSWER_ERROR 0xFFU

/* Why a request was not carried out; the first word of TWD_ANSWER_ERROR. The chip is then as it was before, but that
 * what a refused request was to configure must be configured again. */
enum twd_refusal {
    TWD_REFUSAL_NONE = 0,
    TWD_REFUSAL_DAMAGED = 1, /* a frame came with a CRC that is not its own */
    TWD_REFUSAL_TYPE = 2,    /* no request of this protocol */
    TWD_REFUSAL_PAYLOAD = 3, /* a payload of another length, or a field beyond what it may be */
    TWD_REFUSAL_ORDER = 4,   /* not at this point: see docs/PROTOCOL.md for the order */
    TWD_REFUSAL_LIBRARY = 5  /* the library refused; the second word is its enum twd_error as a signed number */
};

/* The format of the library's numbers in a payload. */
enum twd_numbers {
    TWD_NUMBERS_FLOAT = 1, /* IEEE 754 binary32 */
    TWD_NUMBERS_FIXED = 2  /* two's complement; the table of formats is in docs/PROTOCOL.md */
};

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

/* In a TWD_REQUEST_SUBSTEP: advance the pattern generators by one tick before the torques; the answer then has the new
 * desired angles too. */
#define TWD_SUBSTEP_TICK 1U

/* A payload being written or read, word after word. */
struct twd_transfer {
    struct twd_frame *frame;
    uint16_t at;  /* bytes done */
    bool writing; /* into the frame, or out of it */
    bool failed;  /* no room, no bytes, or a field beyond what it may be: what was read is not to be used */
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
    uint32_t protocol; /* TWD_PROTOCOL_VERSION */
    uint32_t numbers;  /* enum twd_numbers */
    uint32_t joints;   /* TWD_MAX_JOINTS of the chip's build, and so on */
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
void twd_transfer_learner(struct twd_transfer *transfer, struct twd_agent_config *config);

/* What a trial starts with: the answer to TWD_REQUEST_ACT, for a model of `cpgs` CPGs. */
struct twd_trial_start {
    twd_num value;                /* E, the critic's estimate */
    twd_num noise;                /* half-range in force */
    twd_num weight[TWD_MAX_CPGS]; /* [cpgs] s_k, in the model's order */
};
void twd_transfer_trial_start(struct twd_transfer *transfer, struct twd_trial_start *start, uint8_t cpgs);

/* The learner's and the controller's counters: the answer to TWD_REQUEST_STATE. */
struct twd_agent_state {
    uint32_t trials;                    /* learned from */
    struct twd_random random;           /* of the generator of weights and noise */
    struct twd_saturations saturations; /* since TWD_REQUEST_BEGIN */
};
void twd_transfer_state(struct twd_transfer *transfer, struct twd_agent_state *state);

#ifdef __cplusplus
}
#endif
#endif
