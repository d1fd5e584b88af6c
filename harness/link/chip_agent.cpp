#include "chip_agent.hpp"

#include "agent/transfer.h"
#include "configured_chip_agent.hpp"
#include "engine/control_loop.hpp"
#include "engine/controller_setup.hpp"
#include "engine/library_numbers.hpp"
#include "frame_link.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace twiddle::link
{

namespace
{

using engine::LearnerInput;
using namespace engine::TWD_BUILD_NAMESPACE;

// A request, whose payload is written by one call after another.
class Request
{
  public:
    Request() = default;
    Request(const Request &) = delete;
    Request &operator=(const Request &) = delete;

    // `words` point to objects of 32 bits, which stay as they are.
    template <class Word> Request &words(const Word *words, std::size_t count)
    {
        static_assert(sizeof(Word) == sizeof(std::uint32_t), "a payload is a row of words");
        twd_transfer_words(&transfer_, const_cast<Word *>(words), count); // writing reads them alone
        return *this;
    }
    Request &word(std::uint32_t word)
    {
        return words(&word, 1);
    }

    // One of the transfer functions of agent/transfer.h and what it writes.
    template <class Function, class... Values> Request &with(Function function, Values... values)
    {
        function(&transfer_, values...);
        return *this;
    }

    twd_frame &frame()
    {
        if (!twd_transfer_end(&transfer_))
            throw std::logic_error("a request to a chip cannot be written: the protocol knows no such model or size");
        return frame_;
    }

  private:
    twd_frame frame_{};
    twd_transfer transfer_ = twd_transfer_to(&frame_);
};

class ChipAgent : public engine::Agent
{
  public:
    ChipAgent(std::unique_ptr<Connection> connection, const ChipConfig &config)
        : link_(std::move(connection)), config_(config)
    {
        greet();
        configure();
    }

    engine::TrialStart act(const LearnerInput &input) override
    {
        twd_trial_start start{};
        const twd_model &model = *config_.controller.model;
        Request request;
        request.words(library_numbers(input).data(), config_.learner.inputs);
        ask(TWD_REQUEST_ACT, request,
            [&](twd_transfer *answer) { twd_transfer_trial_start(answer, &start, model.cpgs); });
        return {twd_wide_to_double(start.value), twd_num_to_double(start.noise), expert_weights(model, start.weight)};
    }

    const engine::JointCommands &torque(const engine::JointReadings &readings, bool tick) override
    {
        const LibraryReadings numbers = library_readings(readings);
        JointNumbers desired_rad{}, torque_nm{};
        Request request;
        request.word(tick ? TWD_SUBSTEP_TICK : 0U)
            .words(numbers.angle_rad.data(), joint_count)
            .words(numbers.velocity_rad_s.data(), joint_count);
        ask(TWD_REQUEST_SUBSTEP, request, [&](twd_transfer *answer) {
            twd_transfer_words(answer, torque_nm.data(), joint_count);
            if (tick) twd_transfer_words(answer, desired_rad.data(), joint_count);
        });
        if (tick) commands_.desired_rad = joint_vector(desired_rad);
        commands_.torque_nm = joint_vector(torque_nm);
        return commands_;
    }

    double learn(double reward) override
    {
        const twd_wide earned = twd_wide_from_double(reward);
        twd_wide td_error{};
        Request request;
        request.words(&earned, 1);
        ask(TWD_REQUEST_LEARN, request, [&](twd_transfer *answer) { twd_transfer_words(answer, &td_error, 1); });
        return twd_wide_to_double(td_error);
    }

    engine::LearnerState state(const LearnerInput &input) override
    {
        const std::size_t inputs = config_.learner.inputs;
        engine::LearnerState state;
        Request policy;
        policy.words(library_numbers(input).data(), inputs);
        state.policy = ask_for<twd_num>(TWD_REQUEST_POLICY, policy, config_.learner.units, twd_num_to_double);
        for (std::uint32_t unit = 0; unit < config_.learner.units; ++unit) {
            Request actor;
            actor.word(unit);
            state.actor_weights.push_back(ask_for<twd_num>(TWD_REQUEST_ACTOR, actor, inputs, twd_num_to_double));
        }
        Request critic;
        state.critic_weights = ask_for<twd_wide>(TWD_REQUEST_CRITIC, critic, inputs, twd_wide_to_double);
        twd_agent_state counters{};
        Request rest;
        ask(TWD_REQUEST_STATE, rest, [&](twd_transfer *answer) { twd_transfer_state(answer, &counters); });
        state.trials = counters.trials;
        std::copy(std::begin(counters.random.state), std::end(counters.random.state), state.random_state.begin());
        return state;
    }

  private:
    // Ask, and read the answer's payload.
    template <class Read> void ask(twd_request type, Request &request, Read &&read)
    {
        twd_frame answer = link_.ask(type, request.frame());
        twd_transfer transfer = twd_transfer_from(&answer);
        read(&transfer);
        if (!twd_transfer_end(&transfer)) fail_strange();
    }

    void ask_plainly(twd_request type, Request &request)
    {
        ask(type, request, [](twd_transfer *) {});
    }

    // Numbers of the library, of which `to_double` takes one.
    template <class Word, class ToDouble>
    std::vector<double> ask_for(twd_request type, Request &request, std::size_t count, ToDouble to_double)
    {
        std::vector<Word> words(count);
        ask(type, request, [&](twd_transfer *answer) { twd_transfer_words(answer, words.data(), count); });
        return doubles_of(words.data(), count, to_double);
    }

    [[noreturn]] void fail_strange() const
    {
        throw LinkError(link_.name() + " answered with a payload of another build than this program's");
    }

    void greet()
    {
        twd_frame answer = link_.greet();
        twd_hello hello{};
        twd_transfer transfer = twd_transfer_from(&answer);
        twd_transfer_hello(&transfer, &hello);
        if (!twd_transfer_end(&transfer)) fail_strange();
        if (hello.protocol != TWD_PROTOCOL_VERSION)
            throw LinkError(link_.name() + " speaks version " + std::to_string(hello.protocol) +
                            " of the protocol, this program version " + std::to_string(TWD_PROTOCOL_VERSION));
        if (hello.numbers != TWD_NUMBERS_HERE)
            throw LinkError(link_.name() + " does not compute in fixed point, as this program does");
        if (hello.joints < config_.controller.joints || hello.fingers < config_.controller.fingers ||
            hello.units < config_.learner.units || hello.inputs < config_.learner.inputs)
            throw LinkError(link_.name() + " is built for smaller models than set-up '" + config_.name + "' has");
    }

    void configure()
    {
        ChipConfig copy = config_; // the transfer functions take what they could also read into
        Request controller;
        ask_plainly(TWD_REQUEST_CONTROLLER, controller.with(twd_transfer_controller, &copy.controller));
        for (std::uint8_t index = 0; index < config_.controller.joints; ++index) {
            Request joint;
            ask_plainly(TWD_REQUEST_JOINT, joint.with(twd_transfer_joint, &index, &copy.controller.joint[index]));
        }
        for (std::uint8_t index = 0; index < config_.controller.fingers; ++index) {
            Request finger;
            ask_plainly(TWD_REQUEST_FINGER, finger.with(twd_transfer_finger, &index, &copy.controller.finger[index]));
        }
        Request learner;
        ask_plainly(TWD_REQUEST_LEARNER, learner.with(twd_transfer_learner, &copy.learner));
        begin();
    }

    void begin()
    {
        try {
            Request request;
            ask_plainly(TWD_REQUEST_BEGIN, request);
        } catch (const LibraryRefusal &refusal) {
            throw LinkError(link_.name() + " refuses set-up '" + config_.name +
                            "': " + twd_error_text(static_cast<twd_error>(refusal.error())));
        }
    }

    FrameLink link_;
    ChipConfig config_;
    engine::JointCommands commands_; // the last ones
};

} // namespace

ChipConfig chip_config(const engine::AgentSetup &setup)
{
    return {setup.controller.setup.name, controller_config(setup.controller), learner_config(setup)};
}

std::unique_ptr<engine::Agent> make_configured_chip_agent(std::unique_ptr<Connection> connection,
                                                          const ChipConfig &config)
{
    return std::make_unique<ChipAgent>(std::move(connection), config);
}

std::unique_ptr<engine::Agent> make_chip_agent(std::unique_ptr<Connection> connection, const engine::AgentSetup &setup)
{
    return make_configured_chip_agent(std::move(connection), chip_config(setup));
}

} // namespace twiddle::link
