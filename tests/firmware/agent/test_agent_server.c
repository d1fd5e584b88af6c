/* The chip's end of the link: the same words as the library called directly, and what it refuses. */
#include "agent_test.h"

#include "agent/agent_server.h"

#include <twiddle/convert.h>
#include <twiddle/icub_right_hand.h>
#include <twiddle/input_map.h>

#define JOINTS 4
#define UNITS 22

/* A pseudo-random number in [-1, 1). */
static double fraction(uint64_t *random)
{
    return ((double)random_below(random, 2000000) - 1e6) / 1e6;
}

/* CPG-H on the iCub hand, thumb and index weighed. */
static struct twd_controller_config controller_config(void)
{
    static const twd_num held[2] = {TWD_NUM(0.2), TWD_NUM(0.3)};
    static const twd_num down[3] = {0, TWD_NUM(-1), 0};
    struct twd_controller_config config;
    memset(&config, 0, sizeof config);
    config.model = &twd_model_h;
    config.oscillators.with_centre = true;
    config.oscillators.tick_s = TWD_SMALL(0.01);
    config.oscillators.amplitude_rate_per_s = TWD_RATE(5);
    config.oscillators.centre_rate_per_s = TWD_RATE(5);
    config.ranges = (struct twd_parameter_ranges){TWD_NUM(0.5), TWD_NUM(1.5), TWD_NUM(1), TWD_NUM(0.5), 0, TWD_NUM(1)};
    config.joints = JOINTS;
    for (int j = 0; j < JOINTS; j++) {
        config.joint[j].range = twd_icub_joint_range[j];
        config.joint[j].pd = (struct twd_pd){TWD_NUM(0.2), TWD_NUM(0.01), TWD_NUM(0.1)};
    }
    config.fingers = 2;
    static const uint8_t joints[2][2] = {{TWD_ICUB_AAI, TWD_ICUB_FEI}, {TWD_ICUB_OT, TWD_ICUB_FET}};
    for (int f = 0; f < 2; f++) {
        const struct twd_chain *const chain = f == 0 ? &twd_icub_index : &twd_icub_thumb;
        assert_int_equal(twd_gravity_init(&config.finger[f].gravity, chain, 2, held, TWD_WIDE(9.8), down), TWD_OK);
        memcpy(config.finger[f].joint, joints[f], 2);
    }
    return config;
}

static struct twd_learner_config learner_config(void)
{
    const struct twd_learner_config config = {
        .units = UNITS,
        .inputs = TWD_INPUTS,
        .actor_rate = TWD_NUM(0.1),
        .critic_rate = TWD_NUM(0.1),
        .weight_range = TWD_NUM(0.1),
        .clip = TWD_NUM(0.001),
        .noise = {TWD_NUM(0.5), TWD_NUM(0.05), TWD_NUM(0.6), 20},
        .seed = 0x123456789ABCU,
    };
    return config;
}

/* Ask for what server->request holds, of `type`; returns the type of the answer, and checks what every answer has. */
static uint8_t ask(struct twd_agent_server *server, enum twd_request type)
{
    static uint8_t sequence = 0;
    server->request.type = (uint8_t)type;
    server->request.sequence = ++sequence;
    twd_agent_server_answer(server);
    assert_int_equal(server->answer.sequence, sequence);
    assert_true(server->answer.type == ((uint8_t)type | TWD_ANSWER) || server->answer.type == TWD_ANSWER_ERROR);
    return server->answer.type;
}

/* Ask with `count` words, and get `answers` words. */
static void exchange(struct twd_agent_server *server, enum twd_request type, void *words, size_t count, void *answer,
                     size_t answers)
{
    struct twd_transfer transfer = twd_transfer_to(&server->request);
    twd_transfer_words(&transfer, words, count);
    assert_true(twd_transfer_end(&transfer));
    assert_int_equal(ask(server, type), (unsigned)type | TWD_ANSWER);
    transfer = twd_transfer_from(&server->answer);
    twd_transfer_words(&transfer, answer, answers);
    assert_true(twd_transfer_end(&transfer));
}

/* Ask with an empty payload, or with the words that are already there, and be refused. */
static void expect_refusal(struct twd_agent_server *server, uint8_t type, size_t words, enum twd_refusal refusal,
                           enum twd_error error)
{
    server->request.length = (uint16_t)(4 * words);
    assert_int_equal(ask(server, (enum twd_request)type), TWD_ANSWER_ERROR);
    uint32_t answer[2];
    struct twd_transfer transfer = twd_transfer_from(&server->answer);
    twd_transfer_words(&transfer, answer, 2);
    assert_true(twd_transfer_end(&transfer));
    assert_int_equal(answer[0], refusal);
    assert_int_equal((int32_t)answer[1], error);
}

static void send_configuration(struct twd_agent_server *server, struct twd_controller_config controller,
                               struct twd_learner_config learner)
{
    struct twd_transfer transfer = twd_transfer_to(&server->request);
    twd_transfer_controller(&transfer, &controller);
    assert_true(twd_transfer_end(&transfer));
    assert_int_equal(ask(server, TWD_REQUEST_CONTROLLER), TWD_REQUEST_CONTROLLER | TWD_ANSWER);
    for (uint8_t j = 0; j < controller.joints && j < TWD_MAX_JOINTS; j++) {
        transfer = twd_transfer_to(&server->request);
        twd_transfer_joint(&transfer, &j, &controller.joint[j]);
        assert_true(twd_transfer_end(&transfer));
        assert_int_equal(ask(server, TWD_REQUEST_JOINT), TWD_REQUEST_JOINT | TWD_ANSWER);
    }
    for (uint8_t f = 0; f < controller.fingers; f++) {
        transfer = twd_transfer_to(&server->request);
        twd_transfer_finger(&transfer, &f, &controller.finger[f]);
        assert_true(twd_transfer_end(&transfer));
        assert_int_equal(ask(server, TWD_REQUEST_FINGER), TWD_REQUEST_FINGER | TWD_ANSWER);
    }
    transfer = twd_transfer_to(&server->request);
    twd_transfer_learner(&transfer, &learner);
    assert_true(twd_transfer_end(&transfer));
    assert_int_equal(ask(server, TWD_REQUEST_LEARNER), TWD_REQUEST_LEARNER | TWD_ANSWER);
}

/* A server with an agent. */
static void begin(struct twd_agent_server *server)
{
    twd_agent_server_start(server);
    send_configuration(server, controller_config(), learner_config());
    exchange(server, TWD_REQUEST_BEGIN, NULL, 0, NULL, 0);
}

/* What the server is compared with: the library, called directly. */
struct direct {
    struct twd_controller controller;
    struct twd_learner learner;
};

static void begin_direct(struct direct *direct)
{
    const struct twd_controller_config controller = controller_config();
    const struct twd_learner_config learner = learner_config();
    assert_int_equal(twd_controller_init(&direct->controller, &controller), TWD_OK);
    assert_int_equal(twd_learner_init(&direct->learner, &learner), TWD_OK);
}

/* Start a trial on both. */
static void act_on_both(struct twd_agent_server *server, struct direct *direct, twd_num *input)
{
    twd_num parameter[UNITS];
    twd_num start[5];
    exchange(server, TWD_REQUEST_ACT, input, TWD_INPUTS, start, 5);
    twd_learner_act(&direct->learner, input, parameter);
    assert_int_equal(twd_controller_start(&direct->controller, parameter, UNITS), TWD_OK);
    assert_memory_equal(&start[0], &direct->learner.value, 4);
    assert_memory_equal(&start[1], &direct->learner.noise, 4);
    assert_memory_equal(&start[2], direct->controller.weight, 12);
}

/* Move both hands through one substep. */
static void move_both(struct twd_agent_server *server, struct direct *direct, bool tick, twd_num *desired_rad,
                      uint64_t *random)
{
    uint32_t request[1 + 2 * JOINTS] = {tick ? TWD_SUBSTEP_TICK : 0U};
    twd_num angle_rad[JOINTS];
    twd_rate velocity_rad_s[JOINTS];
    for (int j = 0; j < JOINTS; j++) {
        angle_rad[j] = twd_num_from_double(2 * fraction(random));
        velocity_rad_s[j] = twd_rate_from_double(20 * fraction(random));
    }
    memcpy(request + 1, angle_rad, sizeof angle_rad);
    memcpy(request + 1 + JOINTS, velocity_rad_s, sizeof velocity_rad_s);
    twd_num answer[2 * JOINTS];
    exchange(server, TWD_REQUEST_SUBSTEP, request, 1 + 2 * JOINTS, answer, tick ? 2 * JOINTS : JOINTS);

    twd_num torque_nm[JOINTS];
    if (tick) twd_controller_tick(&direct->controller, desired_rad);
    twd_controller_torque(&direct->controller, desired_rad, angle_rad, velocity_rad_s, torque_nm);
    assert_memory_equal(answer, torque_nm, sizeof torque_nm);
    if (tick) assert_memory_equal(answer + JOINTS, desired_rad, 4 * JOINTS);
}

static void expect_same_state(struct twd_agent_server *server, struct direct *direct, twd_num *input)
{
    twd_num parameter[UNITS];
    twd_num answer[TWD_INPUTS];
    twd_learner_policy(&direct->learner, input, parameter);
    exchange(server, TWD_REQUEST_POLICY, input, TWD_INPUTS, answer, UNITS);
    assert_memory_equal(answer, parameter, sizeof parameter);
    for (uint32_t unit = 0; unit < UNITS; unit++) {
        exchange(server, TWD_REQUEST_ACTOR, &unit, 1, answer, TWD_INPUTS);
        assert_memory_equal(answer, direct->learner.actor.weight[unit], sizeof answer);
    }
    exchange(server, TWD_REQUEST_CRITIC, NULL, 0, answer, TWD_INPUTS);
    assert_memory_equal(answer, direct->learner.critic.weight, sizeof answer);

    uint32_t state[8];
    exchange(server, TWD_REQUEST_STATE, NULL, 0, state, 8);
    assert_int_equal(state[0], direct->learner.trial);
    assert_memory_equal(state + 1, direct->learner.random.state, 16);
    assert_int_equal(state[5], direct->controller.saturations.output);
    assert_int_equal(state[6], direct->controller.saturations.torque);
    assert_int_equal(state[7], direct->controller.saturations.input);
}

/* Ten trials through the server give word for word what the library gives when it is called directly: values, noise,
 * weights, torques, desired angles, TD errors, and the learner's state; a trial that is only recalled, without a
 * substep, too. */
static void server_equals_the_library(void **state)
{
    static struct twd_agent_server server;
    static struct direct direct;
    uint64_t random = 20110824;
    twd_num input[TWD_INPUTS];
    (void)state;
    print_message("seed 20110824\n");
    twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.03), TWD_WIDE(10), input);
    begin(&server);
    begin_direct(&direct);
    for (int trial = 0; trial < 10; trial++) {
        act_on_both(&server, &direct, input);
        twd_num desired_rad[TWD_MAX_JOINTS] = {0};
        for (int i = 0; trial != 5 && i < 100; i++)
            move_both(&server, &direct, i % 5 == 0, desired_rad, &random);
        twd_wide reward = twd_wide_from_double(5 * fraction(&random));
        twd_wide td_error;
        exchange(&server, TWD_REQUEST_LEARN, &reward, 1, &td_error, 1);
        const twd_wide expected = twd_learner_learn(&direct.learner, reward);
        assert_memory_equal(&td_error, &expected, sizeof expected);
    }
    assert_true(direct.controller.saturations.torque > 0);
    expect_same_state(&server, &direct, input);
}

/* HELLO says who is there, at any time, and forgets the agent: the next one is configured from nothing. */
static void hello_starts_anew(void **state)
{
    static struct twd_agent_server server;
    uint32_t hello[6];
    (void)state;
    begin(&server);
    exchange(&server, TWD_REQUEST_HELLO, NULL, 0, hello, 6);
    const uint32_t expected[6] = {TWD_PROTOCOL_VERSION, TWD_NUMBERS_HERE, 8, 5, 22, 27};
    assert_memory_equal(hello, expected, sizeof expected);
    expect_refusal(&server, TWD_REQUEST_STATE, 0, TWD_REFUSAL_ORDER, TWD_OK);
    expect_refusal(&server, TWD_REQUEST_BEGIN, 0, TWD_REFUSAL_ORDER, TWD_OK);
}

/* A request at the wrong time is refused and changes nothing. Expected: the order of docs/PROTOCOL.md. */
static void requests_out_of_order_are_refused(void **state)
{
    static struct twd_agent_server server;
    twd_num input[TWD_INPUTS] = {0};
    twd_num words[TWD_INPUTS];
    (void)state;
    twd_agent_server_start(&server);
    static const uint8_t need_agent[] = {TWD_REQUEST_ACT,   TWD_REQUEST_SUBSTEP, TWD_REQUEST_LEARN, TWD_REQUEST_POLICY,
                                         TWD_REQUEST_ACTOR, TWD_REQUEST_CRITIC,  TWD_REQUEST_STATE};
    for (size_t i = 0; i < sizeof need_agent; i++)
        expect_refusal(&server, need_agent[i], 0, TWD_REFUSAL_ORDER, TWD_OK);
    begin(&server);
    for (unsigned type = TWD_REQUEST_CONTROLLER; type <= TWD_REQUEST_BEGIN; type++)
        expect_refusal(&server, (uint8_t)type, 0, TWD_REFUSAL_ORDER, TWD_OK);
    expect_refusal(&server, TWD_REQUEST_SUBSTEP, 1 + 2 * JOINTS, TWD_REFUSAL_ORDER, TWD_OK);
    expect_refusal(&server, TWD_REQUEST_LEARN, 1, TWD_REFUSAL_ORDER, TWD_OK);
    exchange(&server, TWD_REQUEST_ACT, input, TWD_INPUTS, words, 5);
    expect_refusal(&server, TWD_REQUEST_ACT, TWD_INPUTS, TWD_REFUSAL_ORDER, TWD_OK);
    memset(server.request.payload, 0, 4); /* no tick, where nothing is desired yet */
    expect_refusal(&server, TWD_REQUEST_SUBSTEP, 1 + 2 * JOINTS, TWD_REFUSAL_ORDER, TWD_OK);
    exchange(&server, TWD_REQUEST_LEARN, input, 1, words, 1);
    exchange(&server, TWD_REQUEST_ACT, input, TWD_INPUTS, words, 5);
}

/* Types that are no request, and payloads of any other length than the request's, are refused. */
static void unknown_types_and_lengths_are_refused(void **state)
{
    static struct twd_agent_server server;
    static const struct {
        uint8_t type;
        size_t words;
    } requests[] = {{TWD_REQUEST_HELLO, 0}, {TWD_REQUEST_ACT, TWD_INPUTS}, {TWD_REQUEST_POLICY, TWD_INPUTS},
                    {TWD_REQUEST_ACTOR, 1}, {TWD_REQUEST_CRITIC, 0},       {TWD_REQUEST_STATE, 0}};
    (void)state;
    begin(&server);
    memset(server.request.payload, 0, sizeof server.request.payload);
    for (unsigned type = 0; type < 256; type++) {
        const bool known = (type >= 1 && type <= 6) || (type >= 0x10 && type <= 0x12) || (type >= 0x20 && type <= 0x23);
        if (!known) expect_refusal(&server, (uint8_t)type, 0, TWD_REFUSAL_TYPE, TWD_OK);
    }
    for (size_t i = 0; i < sizeof requests / sizeof requests[0]; i++)
        for (size_t words = 0; words <= TWD_FRAME_MAX_PAYLOAD / 4; words++)
            if (words != requests[i].words)
                expect_refusal(&server, requests[i].type, words, TWD_REFUSAL_PAYLOAD, TWD_OK);
    server.request.payload[0] = UNITS;
    expect_refusal(&server, TWD_REQUEST_ACTOR, 1, TWD_REFUSAL_PAYLOAD, TWD_OK);
}

/* What the library refuses is answered with its own code, and there is no agent then. */
static void refusals_of_the_library_carry_its_code(void **state)
{
    static struct twd_agent_server server;
    (void)state;
    twd_agent_server_start(&server);
    struct twd_controller_config controller = controller_config();
    controller.oscillators.tick_s = 0;
    send_configuration(&server, controller, learner_config());
    expect_refusal(&server, TWD_REQUEST_BEGIN, 0, TWD_REFUSAL_LIBRARY, TWD_ERROR_TICK);

    struct twd_learner_config learner = learner_config();
    learner.clip = TWD_NUM(0.7);
    send_configuration(&server, controller_config(), learner);
    expect_refusal(&server, TWD_REQUEST_BEGIN, 0, TWD_REFUSAL_LIBRARY, TWD_ERROR_RANGE);

    learner = learner_config();
    learner.units = 12;
    send_configuration(&server, controller_config(), learner);
    expect_refusal(&server, TWD_REQUEST_BEGIN, 0, TWD_REFUSAL_LIBRARY, TWD_ERROR_PARAMETER_COUNT);
    expect_refusal(&server, TWD_REQUEST_STATE, 0, TWD_REFUSAL_ORDER, TWD_OK);
}

/* A link in memory: what the chip will read, and what it has written. */
struct memory_link {
    const uint8_t *in;
    size_t left;
    size_t piece;
    uint8_t out[4096];
    size_t written;
    bool dead;
};

static size_t read_memory(void *context, uint8_t *bytes, size_t capacity)
{
    struct memory_link *const link = context;
    size_t count = link->left < link->piece ? link->left : link->piece;
    if (count > capacity) count = capacity;
    if (count > 0) memcpy(bytes, link->in, count);
    link->in += count;
    link->left -= count;
    return count;
}

static bool write_memory(void *context, const uint8_t *bytes, size_t count)
{
    struct memory_link *const link = context;
    if (link->dead) return false;
    assert_true(link->written + count <= sizeof link->out);
    memcpy(link->out + link->written, bytes, count);
    link->written += count;
    return true;
}

/* Over a link in pieces of any size, with noise before, between and behind them, every request is answered once and in
 * order, a damaged one by an error; the server ends with its link. */
static void requests_are_answered_over_a_link(void **state)
{
    static struct twd_agent_server server;
    static const struct twd_frame hello = {TWD_REQUEST_HELLO, 5, 0, {0}};
    uint8_t in[200] = {'n', 'o', 'i', 's', 'e', 'T'};
    size_t count = 6;
    (void)state;
    count += twd_frame_encode(&hello, in + count);
    const size_t damaged = count;
    count += twd_frame_encode(&hello, in + count);
    in[damaged + 2] ^= 1;
    in[count++] = 'W';
    count += twd_frame_encode(&hello, in + count);
    for (size_t piece = 1; piece <= count; piece++) {
        struct memory_link memory = {in, count, piece, {0}, 0, false};
        const struct twd_byte_link link = {read_memory, write_memory, &memory};
        twd_agent_server_start(&server);
        twd_agent_server_run(&server, &link);
        assert_int_equal(memory.written, 34 + 18 + 34);
        assert_int_equal(memory.out[2], TWD_REQUEST_HELLO | TWD_ANSWER);
        assert_int_equal(memory.out[34 + 2], TWD_ANSWER_ERROR);
        assert_int_equal(memory.out[34 + 6], TWD_REFUSAL_DAMAGED);
        assert_int_equal(memory.out[34 + 18 + 2], TWD_REQUEST_HELLO | TWD_ANSWER);
    }
    struct memory_link memory = {in, count, 7, {0}, 0, true};
    const struct twd_byte_link link = {read_memory, write_memory, &memory};
    twd_agent_server_start(&server);
    twd_agent_server_run(&server, &link);
}

/* Random requests with random payloads, in any order, are each answered once; nothing else happens. */
static void random_requests_are_answered(void **state)
{
    static struct twd_agent_server server;
    static const uint8_t types[] = {1, 2, 3, 4, 5, 6, 0x10, 0x11, 0x12, 0x20, 0x21, 0x22, 0x23, 0x7F};
    static const uint8_t lengths[] = {0, 4, 36, 68, 56, 24, 108, 152};
    uint64_t random = 7;
    (void)state;
    print_message("seed 7\n");
    begin(&server);
    for (int i = 0; i < 200000; i++) {
        if (i % 1000 == 0) begin(&server);
        const bool tame = random_below(&random, 2) == 0; /* small words pass more checks than random ones */
        for (size_t at = 0; at < TWD_FRAME_MAX_PAYLOAD; at++)
            server.request.payload[at] = (uint8_t)random_below(&random, tame && at % 4 != 0 ? 1 : tame ? 3 : 256);
        server.request.length = lengths[random_below(&random, sizeof lengths)];
        const uint8_t type = types[random_below(&random, sizeof types)];
        if (type == TWD_REQUEST_HELLO && random_below(&random, 20) > 0) continue;
        (void)ask(&server, (enum twd_request)type);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(server_equals_the_library),
        cmocka_unit_test(hello_starts_anew),
        cmocka_unit_test(requests_out_of_order_are_refused),
        cmocka_unit_test(unknown_types_and_lengths_are_refused),
        cmocka_unit_test(refusals_of_the_library_carry_its_code),
        cmocka_unit_test(requests_are_answered_over_a_link),
        cmocka_unit_test(random_requests_are_answered),
    };
    return cmocka_run_group_tests_name("agent_server", tests, NULL, NULL);
}
