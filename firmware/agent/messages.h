/* messages.h: what the frames between a chip and the computer that drives it say (docs/PROTOCOL.md).
 *
 * The computer asks, the chip answers each request once; nobody speaks unasked. A payload is a row of 32-bit words, low
 * byte first: whole numbers, and the library's numbers as the chip's build holds them (enum twd_numbers). transfer.h
 * writes and reads them. */
#ifndef TWIDDLE_AGENT_MESSAGES_H
#define TWIDDLE_AGENT_MESSAGES_H

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

/* In a TWD_REQUEST_SUBSTEP: advance the pattern generators by one tick before the torques; the answer then has the new
 * desired angles too. */
#define TWD_SUBSTEP_TICK 1U

#endif
