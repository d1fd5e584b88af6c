/* agent_server.h: the chip's end of the link: the whole agent, learner and controller, behind requests and answers
 * (messages.h, docs/PROTOCOL.md).
 *
 * No set-up is compiled in: the computer configures controller and learner, starts trials, sends angles and velocities
 * and gets torques, and sends the reward. All memory is in struct twd_agent_server; nothing here knows what carries the
 * bytes. */
#ifndef TWIDDLE_AGENT_AGENT_SERVER_H
#define TWIDDLE_AGENT_AGENT_SERVER_H

#include "agent/agent_names.h"
#include "agent/frame.h"
#include "agent/transfer.h"

TWD_BEGIN_DECLARATIONS

/* How far things have come; each decides which requests are in order. */
enum twd_agent_phase {
    TWD_AGENT_CONFIGURING = 1,    /* no agent yet */
    TWD_AGENT_BETWEEN_TRIALS = 2, /* an agent at rest */
    TWD_AGENT_STARTED = 4,        /* in a trial, before its first tick */
    TWD_AGENT_MOVING = 8          /* in a trial, with desired angles */
};

/* The chip's end. */
struct twd_agent_server {
    enum twd_agent_phase phase;
    /* As far as it has come. */
    struct twd_controller_config controller_config;
    struct twd_learner_config learner_config;
    struct twd_controller controller;
    struct twd_learner learner;
    /* Of the last tick. */
    twd_num desired_rad[TWD_MAX_JOINTS];
    /* enum twd_error of the last refusal, as a signed number. */
    int32_t library_error;
    struct twd_frame_reader reader;
    struct twd_frame request;
    struct twd_frame answer;
    /* The answer, as it goes out. */
    uint8_t bytes[TWD_FRAME_MAX_SIZE];
};

/* A byte link. `context` is handed on to both functions. */
struct twd_byte_link {
    /* Wait for at least one byte and read at most `capacity`; returns how many, or 0 at the link's end. */
    size_t (*read)(void *context, uint8_t *bytes, size_t capacity);
    /* Write all `count` bytes; false at the link's end. */
    bool (*write)(void *context, const uint8_t *bytes, size_t count);
    void *context;
};

/* Make a server that nobody has asked anything yet. */
void twd_agent_server_start(struct twd_agent_server *server);

/* Carry out server->request and put what came of it into server->answer. */
void twd_agent_server_answer(struct twd_agent_server *server);

/* Answer the requests that come over `link` until it ends. */
void twd_agent_server_run(struct twd_agent_server *server, const struct twd_byte_link *link);

TWD_END_DECLARATIONS

#endif
