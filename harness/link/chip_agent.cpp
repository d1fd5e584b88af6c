#include "chip_agent.hpp"

#include "agent/transfer.h"
#include "frame_link.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace twiddle::link
{

namespace
{

using experiment::AgentSetup;
using experiment::LearnerInput;

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

class ChipAgent : public experiment::Agent
{
  public:
    ChipAgent(std::unique_ptr<Connection> connection, const AgentSetup &setup)
        : link_(std::move(connection)), setup_(setup)
    {
        greet();
        configure();
    }

    experiment::TrialStart act(const LearnerInput &input) override
    {
        twd_trial_start start{};
        const twd_model &model = *setup_.controller.model;
        Request request;
        request.words(input.data(), setup_.learner.inputs);
        ask(TWD_REQUEST_ACT, request,
            [&](twd_transfer *answer) { twd_transfer_trial_start(answer, &start, model.cpgs); });
        return {experiment::shown_wide(start.value), experiment::shown_num(start.noise),
                experiment::expert_weights(model, start.weight)};
    }

    experiment::StepCommands advance(sim::World &world, int substeps) override
    {
        experiment::StepCommands commands;
        for (int substep = 0; substep < substeps; ++substep) {
            const experiment::JointReadings readings = experiment::read_joints(world);
            const std::size_t joints = setup_.controller.joints;
            const bool ticks = substep == 0;
            Request request;
            request.word(ticks ? TWD_SUBSTEP_TICK : 0U)
                .words(readings.angle_rad.data(), joints)
                .words(readings.velocity_rad_s.data(), joints);
            experiment::JointNumbers torque_nm{};
            experiment::JointNumbers desired_rad{};
            ask(TWD_REQUEST_SUBSTEP, request, [&](twd_transfer *answer) {
                twd_transfer_words(answer, torque_nm.data(), joints);
                if (ticks) twd_transfer_words(answer, desired_rad.data(), joints);
            });
            if (ticks) commands.desired_rad = experiment::joint_vector(desired_rad);
            commands.torque_nm = experiment::joint_vector(torque_nm);
            world.substep(commands.torque_nm);
        }
        return commands;
    }

    twd_wide learn(twd_wide reward) override
    {
        twd_wide td_error{};
        Request request;
        request.words(&reward, 1);
        ask(TWD_REQUEST_LEARN, request, [&](twd_transfer *answer) { twd_transfer_words(answer, &td_error, 1); });
        return td_error;
    }

    experiment::LearnerState state(const LearnerInput &input) override
    {
        const std::size_t inputs = setup_.learner.inputs;
        experiment::LearnerState state;
        Request policy;
        policy.words(input.data(), inputs);
        state.policy = ask_for<twd_num>(TWD_REQUEST_POLICY, policy, setup_.learner.units);
        for (std::uint32_t unit = 0; unit < setup_.learner.units; ++unit) {
            Request actor;
            actor.word(unit);
            state.actor_weights.push_back(ask_for<twd_num>(TWD_REQUEST_ACTOR, actor, inputs));
        }
        Request critic;
        state.critic_weights = ask_for<twd_wide>(TWD_REQUEST_CRITIC, critic, inputs);
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

    template <class Word> std::vector<Word> ask_for(twd_request type, Request &request, std::size_t count)
    {
        std::vector<Word> words(count);
        ask(type, request, [&](twd_transfer *answer) { twd_transfer_words(answer, words.data(), count); });
        return words;
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
        if (hello.joints < setup_.controller.joints || hello.fingers < setup_.controller.fingers ||
            hello.units < setup_.learner.units || hello.inputs < setup_.learner.inputs)
            throw LinkError(link_.name() + " is built for smaller models than set-up '" + setup_.name + "' has");
    }

    void configure()
    {
        AgentSetup copy = setup_; // the transfer functions take what they could also read into
        Request controller;
        ask_plainly(TWD_REQUEST_CONTROLLER, controller.with(twd_transfer_controller, &copy.controller));
        for (std::uint8_t index = 0; index < setup_.controller.joints; ++index) {
            Request joint;
            ask_plainly(TWD_REQUEST_JOINT, joint.with(twd_transfer_joint, &index, &copy.controller.joint[index]));
        }
        for (std::uint8_t index = 0; index < setup_.controller.fingers; ++index) {
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
            throw LinkError(link_.name() + " refuses set-up '" + setup_.name +
                            "': " + twd_error_text(static_cast<twd_error>(refusal.error())));
        }
    }

    FrameLink link_;
    AgentSetup setup_;
};

} // namespace

std::unique_ptr<experiment::Agent> make_chip_agent(std::unique_ptr<Connection> connection, const AgentSetup &setup)
{
    return std::make_unique<ChipAgent>(std::move(connection), setup);
}

} // namespace twiddle::link
