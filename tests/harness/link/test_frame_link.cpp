#include "../scratch_folder.hpp"
#include "link/frame_link.hpp"
#include "socket_pair.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <thread>
#include <vector>

#include <unistd.h>

namespace
{

using namespace twiddle::link;
using std::chrono::milliseconds;
using std::chrono::steady_clock;
using twiddle::test::error_of;
using twiddle::test::SocketConnection;
using twiddle::test::SocketPair;

// A link whose chip's end understands requests.
class Pair : public SocketPair
{
  public:
    // The next request that comes to the chip's end.
    twd_frame take_request()
    {
        twd_frame frame{};
        while (twd_frame_reader_next(&reader_, &frame) != TWD_FRAME_WHOLE) {
            std::size_t capacity = 0;
            std::uint8_t *space = twd_frame_reader_space(&reader_, &capacity);
            const ssize_t count = ::read(chips(), space, capacity);
            if (count <= 0) throw std::runtime_error("the link was closed");
            twd_frame_reader_filled(&reader_, static_cast<std::size_t>(count));
        }
        return frame;
    }

  private:
    twd_frame_reader reader_{};
};

void put(const Pair &pair, const std::vector<std::uint8_t> &bytes)
{
    ASSERT_EQ(::write(pair.chips(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
}

std::vector<std::uint8_t> bytes_of(unsigned type, unsigned sequence, const std::vector<std::uint8_t> &payload = {})
{
    twd_frame frame{};
    frame.type = static_cast<std::uint8_t>(type);
    frame.sequence = static_cast<std::uint8_t>(sequence);
    frame.length = static_cast<std::uint16_t>(payload.size());
    std::copy(payload.begin(), payload.end(), std::begin(frame.payload));
    std::array<std::uint8_t, TWD_FRAME_MAX_SIZE> bytes{};
    const std::size_t count = twd_frame_encode(&frame, bytes.data());
    return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
}

// Ask for a TD error while a chip behaves as `chip`; returns what is thrown.
std::string complaint(Pair &pair, const std::function<void(const twd_frame &)> &chip, const std::string &death = "")
{
    FrameLink link(std::make_unique<SocketConnection>(pair, death));
    std::thread thread([&] { chip(pair.take_request()); });
    const std::string sentence = error_of([&] {
        twd_frame request{};
        link.ask(TWD_REQUEST_LEARN, request);
    });
    thread.join();
    return sentence;
}

// An answer comes back, whatever noise and late greetings are before it, and in whatever pieces it comes.
TEST(FrameLink, answer_is_found_behind_noise)
{
    Pair pair;
    FrameLink link(std::make_unique<SocketConnection>(pair));
    for (int round = 0; round < 600; ++round) { // more than there are sequence numbers
        std::thread chip([&] {
            const twd_frame request = pair.take_request();
            ASSERT_NE(request.sequence, 0);
            ASSERT_EQ(request.type, TWD_REQUEST_LEARN);
            put(pair, {'n', 'o', 'T', 'W', 'i'});
            put(pair, bytes_of(TWD_REQUEST_HELLO | TWD_ANSWER, request.sequence - 1U));
            const auto answer = bytes_of(TWD_REQUEST_LEARN | TWD_ANSWER, request.sequence, {1, 2, 3, 4});
            put(pair, {answer.begin(), answer.begin() + 5});
            put(pair, {answer.begin() + 5, answer.end()});
        });
        twd_frame request{};
        const twd_frame &answer = link.ask(TWD_REQUEST_LEARN, request);
        chip.join();
        ASSERT_EQ(answer.length, 4);
        ASSERT_EQ(answer.payload[3], 4);
    }
}

// A greeting is repeated until it is answered, and an unfinished frame on the chip's side does not swallow it.
TEST(FrameLink, greeting_reaches_a_chip_that_wakes_late)
{
    Pair pair;
    FrameLink link(std::make_unique<SocketConnection>(pair));
    std::thread chip([&] {
        std::this_thread::sleep_for(milliseconds(700));
        put(pair, {0, 'b', 'o', 'o', 't', '\n'});
        put(pair, bytes_of(TWD_ANSWER_ERROR, 0, {1, 0, 0, 0, 0, 0, 0, 0}));
        (void)pair.take_request(); // too late for this one
        const twd_frame request = pair.take_request();
        put(pair, bytes_of(TWD_REQUEST_HELLO | TWD_ANSWER, request.sequence, {7, 0, 0, 0}));
    });
    const twd_frame &answer = link.greet();
    chip.join();
    EXPECT_EQ(answer.payload[0], 7);
}

// A chip that says nothing is given up within 5 s, at the greeting and later, with a sentence that names it.
TEST(FrameLink, silence_is_given_up_within_5_s)
{
    const auto start = steady_clock::now();
    Pair pair;
    EXPECT_EQ(complaint(pair, [](const twd_frame &) {}), "the chip has not answered for 3 s");
    EXPECT_LT(steady_clock::now() - start, milliseconds(5000));

    const auto greeting = steady_clock::now();
    FrameLink link(std::make_unique<SocketConnection>(pair));
    const std::string sentence = error_of([&] { link.greet(); });
    EXPECT_EQ(sentence.find("the chip does not answer"), 0U) << sentence;
    EXPECT_LT(steady_clock::now() - greeting, milliseconds(5000));
}

// A link that takes nothing more is given up within 5 s.
TEST(FrameLink, full_link_is_given_up_within_5_s)
{
    Pair pair;
    const std::array<char, 4096> bytes{};
    while (::write(pair.ours(), bytes.data(), bytes.size()) > 0) {
    }
    while (::write(pair.ours(), bytes.data(), 1) > 0) {
    }
    const auto start = steady_clock::now();
    FrameLink link(std::make_unique<SocketConnection>(pair));
    twd_frame request{};
    EXPECT_THROW(link.ask(TWD_REQUEST_LEARN, request), LinkError);
    EXPECT_LT(steady_clock::now() - start, milliseconds(5000));
}

// A damaged answer, a chip that received damage, and one that refuses, are told from each other at once.
TEST(FrameLink, wrong_answers_are_told_apart)
{
    const auto start = steady_clock::now();
    Pair pair;
    const auto answer = [&](unsigned type, int sequence_step, const std::vector<std::uint8_t> &payload) {
        return complaint(pair, [&](const twd_frame &request) {
            const auto sequence = sequence_step < 0 ? 0U : request.sequence + static_cast<unsigned>(sequence_step);
            put(pair, bytes_of(type, sequence, payload));
        });
    };
    const auto refusal = [&](std::uint8_t code, std::uint8_t detail) {
        return answer(TWD_ANSWER_ERROR, 0, {code, 0, 0, 0, detail, 255, 255, 255});
    };
    EXPECT_EQ(complaint(pair,
                        [&](const twd_frame &request) {
                            auto bytes = bytes_of(TWD_REQUEST_LEARN | TWD_ANSWER, request.sequence, {1, 2, 3, 4});
                            bytes[8] ^= 0x20;
                            put(pair, bytes);
                        }),
              "the chip sent a damaged frame: its CRC is not that of its bytes");
    EXPECT_NE(answer(TWD_ANSWER_ERROR, -1, {1, 0, 0, 0, 0, 0, 0, 0}).find("received a damaged frame"),
              std::string::npos);
    EXPECT_NE(refusal(TWD_REFUSAL_TYPE, 255).find("does not know a request"), std::string::npos);
    EXPECT_NE(refusal(TWD_REFUSAL_PAYLOAD, 255).find("another build"), std::string::npos);
    EXPECT_NE(refusal(TWD_REFUSAL_ORDER, 255).find("out of order"), std::string::npos);
    EXPECT_NE(refusal(TWD_REFUSAL_LIBRARY, 247).find("refused a request: error -9 of twiddle/error.h"),
              std::string::npos);
    EXPECT_NE(refusal(99, 0).find("unknown error 99"), std::string::npos);
    EXPECT_NE(answer(TWD_REQUEST_ACT | TWD_ANSWER, 0, {}).find("another request"), std::string::npos);
    EXPECT_LT(steady_clock::now() - start, milliseconds(2000));
}

// A link that was closed, and a chip that is known to be dead, are told at once, by what is known of the death.
TEST(FrameLink, death_is_told_at_once)
{
    const auto start = steady_clock::now();
    Pair closed;
    const std::string sentence = complaint(closed, [&](const twd_frame &) { closed.close_chips(); });
    EXPECT_EQ(sentence.find("the chip has gone: "), 0U) << sentence;
    Pair pair;
    EXPECT_EQ(complaint(
                  pair, [](const twd_frame &) {}, "has gone: it fell"),
              "the chip has gone: it fell");
    EXPECT_LT(steady_clock::now() - start, milliseconds(2000));
}

} // namespace
