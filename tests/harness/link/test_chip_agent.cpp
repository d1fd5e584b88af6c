#include "../scratch_folder.hpp"
#include "agent/agent_server.h"
#include "engine/engine.hpp"
#include "link/chip_agent.hpp"
#include "link/configured_chip_agent.hpp"
#include "sim/object.hpp"
#include "socket_pair.hpp"

#include "setups.hpp"

#include <twiddle/convert.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <unistd.h>

namespace
{

using namespace twiddle;
using namespace twiddle::engine;
using test::error_of;
using test::SocketConnection;
using test::SocketPair;

// Changes an answer before it is sent.
using Meddling = std::function<void(twd_frame &)>;

// A chip in a thread, whose answers may be meddled with.
class Chip
{
  public:
    explicit Chip(Meddling meddling = {}) : meddling_(std::move(meddling)), thread_([this] { serve(); })
    {
    }
    ~Chip()
    {
        pair_.close_ours();
        thread_.join();
    }
    Chip(const Chip &) = delete;
    Chip &operator=(const Chip &) = delete;

    std::unique_ptr<link::Connection> connection() const
    {
        return std::make_unique<SocketConnection>(pair_);
    }

  private:
    void serve()
    {
        const auto read = [](void *chip, std::uint8_t *bytes, std::size_t capacity) {
            const ssize_t count = ::read(static_cast<Chip *>(chip)->pair_.chips(), bytes, capacity);
            return count > 0 ? static_cast<std::size_t>(count) : 0;
        };
        const auto write = [](void *chip, const std::uint8_t *bytes, std::size_t count) {
            return static_cast<Chip *>(chip)->write(bytes, count);
        };
        const twd_byte_link link = {read, write, this};
        twd_agent_server_start(&server_);
        twd_agent_server_run(&server_, &link);
    }

    bool write(const std::uint8_t *bytes, std::size_t count)
    {
        twd_frame_reader reader{};
        std::copy(bytes, bytes + count, reader.buffer);
        reader.count = count;
        twd_frame answer{};
        twd_frame_reader_next(&reader, &answer);
        if (meddling_) meddling_(answer);
        std::array<std::uint8_t, TWD_FRAME_MAX_SIZE> out{};
        const std::size_t size = twd_frame_encode(&answer, out.data());
        return ::write(pair_.chips(), out.data(), size) == static_cast<ssize_t>(size);
    }

    SocketPair pair_;
    Meddling meddling_;
    twd_agent_server server_{};
    std::thread thread_;
};

AgentSetup setup()
{
    return {{test::load_setup("paper"), "cpg-h", true}, 20, 7};
}

link::ChipConfig config()
{
    return link::chip_config(setup());
}

// Make the word `index` of each answer of `type` another.
Meddling with_word(unsigned type, std::size_t index, std::uint8_t value)
{
    return [=](twd_frame &answer) {
        if (answer.type == (type | TWD_ANSWER)) answer.payload[4 * index] = value;
    };
}

std::string complaint(const link::ChipConfig &config, const Meddling &meddling)
{
    const Chip chip(meddling);
    return error_of([&] { link::make_configured_chip_agent(chip.connection(), config); });
}

// A chip's agent says the same as one in this process, trial after trial, and has come to the same in the end.
TEST(ChipAgent, chip_says_the_same_as_this_process)
{
    const Chip chip;
    const auto there = link::make_chip_agent(chip.connection(), setup());
    const Engine &fixed = engine_of_number("fixed");
    const auto here = fixed.make_agent(setup());
    const LearnerInput input =
        fixed.learner_input(sim::read_object(TWIDDLE_MODELS, "small-cube"), test::load_setup("paper").learner);
    for (int trial = 0; trial < 20; ++trial) {
        const TrialStart a = there->act(input);
        const TrialStart b = here->act(input);
        EXPECT_EQ(a.value, b.value);
        EXPECT_EQ(a.noise, b.noise);
        EXPECT_EQ(a.weight, b.weight);
        const double reward = 0.1 * trial - 0.7;
        EXPECT_EQ(there->learn(reward), here->learn(reward));
    }
    const LearnerState a = there->state(input);
    const LearnerState b = here->state(input);
    EXPECT_EQ(a.trials, 20U);
    EXPECT_EQ(a.trials, b.trials);
    EXPECT_EQ(a.policy, b.policy);
    EXPECT_EQ(a.actor_weights, b.actor_weights);
    EXPECT_EQ(a.critic_weights, b.critic_weights);
    EXPECT_EQ(a.random_state, b.random_state);
}

// A chip of another protocol, another number format or smaller arrays is refused, each by its own sentence. Expected:
// the words of the answer to HELLO in docs/PROTOCOL.md.
TEST(ChipAgent, chips_that_do_not_fit_are_refused)
{
    const auto hello = [](std::size_t index, std::uint8_t value) {
        return complaint(config(), with_word(TWD_REQUEST_HELLO, index, value));
    };
    EXPECT_EQ(hello(0, 2), "the chip speaks version 2 of the protocol, this program version 1");
    EXPECT_EQ(hello(1, TWD_NUMBERS_FLOAT), "the chip does not compute in fixed point, as this program does");
    for (const auto &[index, value] : {std::pair{2, 3}, std::pair{3, 1}, std::pair{4, 21}, std::pair{5, 26}}) {
        EXPECT_EQ(hello(static_cast<std::size_t>(index), static_cast<std::uint8_t>(value)),
                  "the chip is built for smaller models than set-up 'paper' has");
    }
    const auto longer = [](twd_frame &answer) {
        if (answer.type == (TWD_REQUEST_BEGIN | TWD_ANSWER)) answer.length = 4;
    };
    EXPECT_EQ(complaint(config(), longer), "the chip answered with a payload of another build than this program's");
}

// A model that the protocol has no number for is not taken for another.
TEST(ChipAgent, model_without_a_number_is_refused)
{
    const twd_model unknown = twd_model_h;
    link::ChipConfig other = config();
    other.controller.model = &unknown;
    const Chip chip;
    EXPECT_THROW(link::make_configured_chip_agent(chip.connection(), other), std::logic_error);
}

// What the library on the chip refuses is said in its words.
TEST(ChipAgent, refusal_of_the_library_is_told)
{
    link::ChipConfig bad = config();
    bad.learner.clip = twd_num_from_double(0.7);
    EXPECT_EQ(complaint(bad, {}), std::string("the chip refuses set-up 'paper': ") + twd_error_text(TWD_ERROR_RANGE));
}

} // namespace
