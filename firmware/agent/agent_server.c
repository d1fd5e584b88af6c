#include "agent/agent_server.h"

#include <string.h>

/* Whether a payload was read or written as a whole, as an answer to the request. */
static enum twd_refusal ended(struct twd_transfer *transfer)
{
    return twd_transfer_end(transfer) ? TWD_REFUSAL_NONE : TWD_REFUSAL_PAYLOAD;
}

static enum twd_refusal library(struct twd_agent_server *server, enum twd_error error)
{
    server->library_error = (int32_t)error;
    return error == TWD_OK ? TWD_REFUSAL_NONE : TWD_REFUSAL_LIBRARY;
}

static enum twd_refusal answer_words(struct twd_agent_server *server, void *words, size_t count)
{
    struct twd_transfer answer = twd_transfer_to(&server->answer);
    twd_transfer_words(&answer, words, count);
    return ended(&answer);
}

static enum twd_refusal request_words(struct twd_agent_server *server, void *words, size_t count)
{
    struct twd_transfer request = twd_transfer_from(&server->request);
    twd_transfer_words(&request, words, count);
    return ended(&request);
}

static enum twd_refusal hello(struct twd_agent_server *server)
{
    memset(&server->controller_config, 0, sizeof server->controller_config);
    memset(&server->learner_config, 0, sizeof server->learner_config);
    server->phase = TWD_AGENT_CONFIGURING;

    struct twd_hello hello = {TWD_PROTOCOL_VERSION, TWD_NUMBERS_HERE, TWD_MAX_JOINTS,
                              TWD_MAX_CHAINS,       TWD_MAX_UNITS,    TWD_MAX_INPUTS};
    struct twd_transfer answer = twd_transfer_to(&server->answer);
    twd_transfer_hello(&answer, &hello);
    return ended(&answer);
}

static enum twd_refusal configure_controller(struct twd_agent_server *server)
{
    struct twd_transfer request = twd_transfer_from(&server->request);
    twd_transfer_controller(&request, &server->controller_config);
    return ended(&request);
}

static enum twd_refusal configure_joint(struct twd_agent_server *server)
{
    static const struct twd_joint none;
    struct twd_joint joint = none;
    uint8_t index = 0;
    struct twd_transfer request = twd_transfer_from(&server->request);
    twd_transfer_joint(&request, &index, &joint);
    if (!twd_transfer_end(&request) || index >= TWD_MAX_JOINTS) return TWD_REFUSAL_PAYLOAD;
    server->controller_config.joint[index] = joint;
    return TWD_REFUSAL_NONE;
}

static enum twd_refusal configure_finger(struct twd_agent_server *server)
{
    static const struct twd_finger none;
    struct twd_finger finger = none;
    uint8_t index = 0;
    struct twd_transfer request = twd_transfer_from(&server->request);
    twd_transfer_finger(&request, &index, &finger);
    if (!twd_transfer_end(&request) || index >= TWD_MAX_CHAINS) return TWD_REFUSAL_PAYLOAD;
    server->controller_config.finger[index] = finger;
    return TWD_REFUSAL_NONE;
}

static enum twd_refusal configure_learner(struct twd_agent_server *server)
{
    struct twd_transfer request = twd_transfer_from(&server->request);
    twd_transfer_learner(&request, &server->learner_config);
    return ended(&request);
}

static enum twd_refusal begin(struct twd_agent_server *server)
{
    const struct twd_controller_config *const config = &server->controller_config;
    if (config->model == NULL) return TWD_REFUSAL_ORDER; /* no TWD_REQUEST_CONTROLLER yet */
    if (server->learner_config.units != twd_model_parameters(config->model, config->oscillators.with_centre))
        return library(server, TWD_ERROR_PARAMETER_COUNT);
    enum twd_error error = twd_controller_init(&server->controller, config);
    if (error == TWD_OK) error = twd_learner_init(&server->learner, &server->learner_config);
    if (error == TWD_OK) server->phase = TWD_AGENT_BETWEEN_TRIALS;
    return library(server, error);
}

static enum twd_refusal act(struct twd_agent_server *server)
{
    struct twd_learner *const learner = &server->learner;
    const struct twd_controller *const controller = &server->controller;
    twd_num input[TWD_MAX_INPUTS];
    const enum twd_refusal refusal = request_words(server, input, learner->config.inputs);
    if (refusal != TWD_REFUSAL_NONE) return refusal;

    twd_num parameter[TWD_MAX_UNITS];
    twd_learner_act(learner, input, parameter);
    const enum twd_error error = twd_controller_start(&server->controller, parameter, learner->config.units);
    if (error != TWD_OK) return library(server, error);
    server->phase = TWD_AGENT_STARTED;

    struct twd_trial_start start = {learner->value, learner->noise, {TWD_NUM(0)}};
    const uint8_t cpgs = controller->config.model->cpgs;
    for (uint8_t k = 0; k < cpgs; k++)
        start.weight[k] = controller->weight[k];
    struct twd_transfer answer = twd_transfer_to(&server->answer);
    twd_transfer_trial_start(&answer, &start, cpgs);
    return ended(&answer);
}

static enum twd_refusal substep(struct twd_agent_server *server)
{
    const size_t joints = server->controller.config.joints;
    uint32_t flags = 0;
    twd_num angle_rad[TWD_MAX_JOINTS];
    twd_rate velocity_rad_s[TWD_MAX_JOINTS];
    struct twd_transfer request = twd_transfer_from(&server->request);
    twd_transfer_words(&request, &flags, 1);
    twd_transfer_words(&request, angle_rad, joints);
    twd_transfer_words(&request, velocity_rad_s, joints);
    if (!twd_transfer_end(&request) || flags > TWD_SUBSTEP_TICK) return TWD_REFUSAL_PAYLOAD;
    const bool ticks = flags == TWD_SUBSTEP_TICK;
    if (!ticks && server->phase != TWD_AGENT_MOVING) return TWD_REFUSAL_ORDER; /* nothing is desired yet */

    if (ticks) twd_controller_tick(&server->controller, server->desired_rad);
    server->phase = TWD_AGENT_MOVING;
    twd_num torque_nm[TWD_MAX_JOINTS];
    twd_controller_torque(&server->controller, server->desired_rad, angle_rad, velocity_rad_s, torque_nm);
    struct twd_transfer answer = twd_transfer_to(&server->answer);
    twd_transfer_words(&answer, torque_nm, joints);
    if (ticks) twd_transfer_words(&answer, server->desired_rad, joints);
    return ended(&answer);
}

static enum twd_refusal learn(struct twd_agent_server *server)
{
    twd_wide reward;
    const enum twd_refusal refusal = request_words(server, &reward, 1);
    if (refusal != TWD_REFUSAL_NONE) return refusal;
    twd_wide td_error = twd_learner_learn(&server->learner, reward);
    server->phase = TWD_AGENT_BETWEEN_TRIALS;
    return answer_words(server, &td_error, 1);
}

static enum twd_refusal policy(struct twd_agent_server *server)
{
    twd_num input[TWD_MAX_INPUTS];
    const enum twd_refusal refusal = request_words(server, input, server->learner.config.inputs);
    if (refusal != TWD_REFUSAL_NONE) return refusal;
    twd_num parameter[TWD_MAX_UNITS];
    twd_learner_policy(&server->learner, input, parameter);
    return answer_words(server, parameter, server->learner.config.units);
}

static enum twd_refusal actor(struct twd_agent_server *server)
{
    uint32_t unit = 0;
    const enum twd_refusal refusal = request_words(server, &unit, 1);
    if (refusal != TWD_REFUSAL_NONE) return refusal;
    if (unit >= server->learner.config.units) return TWD_REFUSAL_PAYLOAD;
    return answer_words(server, server->learner.actor.weight[unit], server->learner.config.inputs);
}

static enum twd_refusal critic(struct twd_agent_server *server)
{
    return answer_words(server, server->learner.critic.weight, server->learner.config.inputs);
}

static enum twd_refusal state(struct twd_agent_server *server)
{
    struct twd_agent_state state = {server->learner.trial, server->learner.random, server->controller.saturations};
    struct twd_transfer answer = twd_transfer_to(&server->answer);
    twd_transfer_state(&answer, &state);
    return ended(&answer);
}

#define IN_A_TRIAL (TWD_AGENT_STARTED | TWD_AGENT_MOVING)
#define WITH_AN_AGENT (TWD_AGENT_BETWEEN_TRIALS | IN_A_TRIAL)

/* A request, when it is in order, and what carries it out. */
struct service {
    uint8_t type;
    uint8_t phases; /* a sum of enum twd_agent_phase */
    bool has_payload;
    enum twd_refusal (*carry_out)(struct twd_agent_server *server);
};

static const struct service services[] = {
    {TWD_REQUEST_SUBSTEP, IN_A_TRIAL, true, substep}, /* the most frequent first */
    {TWD_REQUEST_ACT, TWD_AGENT_BETWEEN_TRIALS, true, act},
    {TWD_REQUEST_LEARN, IN_A_TRIAL, true, learn},
    {TWD_REQUEST_HELLO, TWD_AGENT_CONFIGURING | WITH_AN_AGENT, false, hello},
    {TWD_REQUEST_CONTROLLER, TWD_AGENT_CONFIGURING, true, configure_controller},
    {TWD_REQUEST_JOINT, TWD_AGENT_CONFIGURING, true, configure_joint},
    {TWD_REQUEST_FINGER, TWD_AGENT_CONFIGURING, true, configure_finger},
    {TWD_REQUEST_LEARNER, TWD_AGENT_CONFIGURING, true, configure_learner},
    {TWD_REQUEST_BEGIN, TWD_AGENT_CONFIGURING, false, begin},
    {TWD_REQUEST_POLICY, WITH_AN_AGENT, true, policy},
    {TWD_REQUEST_ACTOR, WITH_AN_AGENT, true, actor},
    {TWD_REQUEST_CRITIC, WITH_AN_AGENT, false, critic},
    {TWD_REQUEST_STATE, WITH_AN_AGENT, false, state},
};

static enum twd_refusal carry_out(struct twd_agent_server *server)
{
    for (size_t i = 0; i < sizeof services / sizeof services[0]; i++) {
        const struct service *const service = &services[i];
        if (service->type != server->request.type) continue;
        if ((service->phases & (unsigned)server->phase) == 0) return TWD_REFUSAL_ORDER;
        if (!service->has_payload && server->request.length > 0) return TWD_REFUSAL_PAYLOAD;
        return service->carry_out(server);
    }
    return TWD_REFUSAL_TYPE;
}

static void answer_error(struct twd_agent_server *server, enum twd_refusal refusal)
{
    uint32_t words[2] = {(uint32_t)refusal, 0};
    if (refusal == TWD_REFUSAL_LIBRARY) words[1] = (uint32_t)server->library_error;
    server->answer.type = TWD_ANSWER_ERROR;
    (void)answer_words(server, words, 2); /* two words always fit */
}

void twd_agent_server_start(struct twd_agent_server *server)
{
    memset(server, 0, sizeof *server);
    server->phase = TWD_AGENT_CONFIGURING;
}

void twd_agent_server_answer(struct twd_agent_server *server)
{
    server->answer.type = (uint8_t)(server->request.type | TWD_ANSWER);
    server->answer.sequence = server->request.sequence;
    server->answer.length = 0;
    const enum twd_refusal refusal = carry_out(server);
    if (refusal != TWD_REFUSAL_NONE) answer_error(server, refusal);
}

/* Answer all frames that have arrived; false at the link's end. */
static bool answer_all(struct twd_agent_server *server, const struct twd_byte_link *link)
{
    for (;;) {
        const enum twd_frame_found found = twd_frame_reader_next(&server->reader, &server->request);
        if (found == TWD_FRAME_NONE) return true;
        if (found == TWD_FRAME_WHOLE) {
            twd_agent_server_answer(server);
        } else {
            server->answer.sequence = 0; /* whose request it was is not known */
            answer_error(server, TWD_REFUSAL_DAMAGED);
        }
        const size_t count = twd_frame_encode(&server->answer, server->bytes);
        if (!link->write(link->context, server->bytes, count)) return false;
    }
}

void twd_agent_server_run(struct twd_agent_server *server, const struct twd_byte_link *link)
{
    while (answer_all(server, link)) {
        size_t capacity = 0;
        uint8_t *const space = twd_frame_reader_space(&server->reader, &capacity);
        const size_t count = link->read(link->context, space, capacity);
        if (count == 0) return;
        twd_frame_reader_filled(&server->reader, count);
    }
}
