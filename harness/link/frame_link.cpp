#include "frame_link.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <thread>

#include <poll.h>
#include <unistd.h>

namespace twiddle::link
{

namespace
{

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds greeting_interval{500};
constexpr milliseconds slice{100};       // between two looks at whether the chip has died
constexpr milliseconds death_limit{500}; // for a process to be gone after its link

// Whether `descriptor` became ready for `events` before the deadline, or before it is time to look around.
bool is_ready(int descriptor, short events, steady_clock::time_point deadline)
{
    const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
    pollfd source = {descriptor, events, 0};
    const auto wait = std::clamp(left, milliseconds(0), slice);
    return ::poll(&source, 1, static_cast<int>(wait.count())) > 0;
}

std::uint32_t word(const twd_frame &frame, std::size_t index)
{
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) {
        value = value << 8 | frame.payload[4 * index + i];
    }
    return value;
}

std::string refusal_text(std::uint32_t refusal)
{
    switch (refusal) {
    case TWD_REFUSAL_DAMAGED:
        return "received a damaged frame: what was sent does not arrive as it was";
    case TWD_REFUSAL_TYPE:
        return "does not know a request that this program made";
    case TWD_REFUSAL_PAYLOAD:
        return "refused a request for its payload: its firmware is of another build than this program";
    case TWD_REFUSAL_ORDER:
        return "refused a request as out of order: it has been reset, or something else talks to it";
    default:
        return "answered with the unknown error " + std::to_string(refusal);
    }
}

} // namespace

FrameLink::FrameLink(std::unique_ptr<Connection> connection) : connection_(std::move(connection))
{
}

const twd_frame &FrameLink::greet()
{
    // Whatever was left unfinished on the chip's side ends with these.
    static constexpr std::array<std::uint8_t, TWD_FRAME_MAX_SIZE> zeros{};
    const Time end = steady_clock::now() + start_limit;
    write(zeros.data(), zeros.size(), end);
    while (steady_clock::now() < end) {
        twd_frame request{};
        const Time deadline = std::min(end, steady_clock::now() + greeting_interval);
        send(TWD_REQUEST_HELLO, request, deadline);
        for (;;) {
            const twd_frame_found found = next(deadline);
            if (found == TWD_FRAME_NONE) break;
            if (found == TWD_FRAME_WHOLE && answer_.type == (TWD_REQUEST_HELLO | TWD_ANSWER) &&
                answer_.sequence == sequence_)
                return answer_;
        }
    }
    fail("does not answer: no agent that speaks the protocol of docs/PROTOCOL.md is there");
}

const twd_frame &FrameLink::ask(twd_request type, twd_frame &request)
{
    const Time deadline = steady_clock::now() + answer_limit;
    send(type, request, deadline);
    for (;;) {
        const twd_frame_found found = next(deadline);
        if (found == TWD_FRAME_NONE)
            fail("has not answered for " +
                 std::to_string(std::chrono::duration_cast<std::chrono::seconds>(answer_limit).count()) + " s");
        if (found == TWD_FRAME_DAMAGED) fail("sent a damaged frame: its CRC is not that of its bytes");
        // An error without a sequence number is about a frame that arrived damaged; other strange numbers are late
        // greetings.
        if (answer_.type == TWD_ANSWER_ERROR && (answer_.sequence == sequence_ || answer_.sequence == 0))
            fail_refused();
        if (answer_.sequence != sequence_) continue;
        if (answer_.type != (static_cast<unsigned>(type) | TWD_ANSWER)) fail("answered another request than the last");
        return answer_;
    }
}

std::string FrameLink::name() const
{
    return connection_->name();
}

void FrameLink::send(twd_request type, twd_frame &request, Time deadline)
{
    sequence_ = sequence_ == UINT8_MAX ? 1 : static_cast<std::uint8_t>(sequence_ + 1); // 0 is nobody's
    request.type = static_cast<std::uint8_t>(type);
    request.sequence = sequence_;
    std::array<std::uint8_t, TWD_FRAME_MAX_SIZE> bytes{};
    write(bytes.data(), twd_frame_encode(&request, bytes.data()), deadline);
}

void FrameLink::write(const std::uint8_t *bytes, std::size_t count, Time deadline)
{
    while (count > 0) {
        const ssize_t written = ::write(connection_->output(), bytes, count);
        if (written < 0 && errno != EAGAIN && errno != EINTR) fail_ended(std::strerror(errno));
        if (written > 0) {
            bytes += written;
            count -= static_cast<std::size_t>(written);
        } else if (!is_ready(connection_->output(), POLLOUT, deadline) && steady_clock::now() >= deadline) {
            fail("does not take what is sent to it");
        }
    }
}

twd_frame_found FrameLink::next(Time deadline)
{
    for (;;) {
        const twd_frame_found found = twd_frame_reader_next(&reader_, &answer_);
        if (found != TWD_FRAME_NONE || !read_some(deadline)) return found;
    }
}

bool FrameLink::read_some(Time deadline)
{
    for (;;) {
        if (is_ready(connection_->input(), POLLIN, deadline)) {
            std::size_t capacity = 0;
            std::uint8_t *space = twd_frame_reader_space(&reader_, &capacity);
            const ssize_t count = ::read(connection_->input(), space, capacity);
            if (count > 0) {
                twd_frame_reader_filled(&reader_, static_cast<std::size_t>(count));
                return true;
            }
            if (count == 0 || (errno != EAGAIN && errno != EINTR))
                fail_ended(count == 0 ? "the link was closed" : std::strerror(errno));
        } else if (const std::string death = connection_->death(); !death.empty()) {
            fail(death);
        }
        if (steady_clock::now() >= deadline) return false;
    }
}

void FrameLink::fail(const std::string &rest) const
{
    throw LinkError(connection_->name() + " " + rest);
}

// The chip answered with an error.
void FrameLink::fail_refused() const
{
    if (answer_.length != 8) fail("answered with an error of another protocol");
    const std::uint32_t refusal = word(answer_, 0);
    if (refusal != TWD_REFUSAL_LIBRARY) fail(refusal_text(refusal));
    const auto error = static_cast<std::int32_t>(word(answer_, 1));
    throw LibraryRefusal(
        connection_->name() + " refused a request: error " + std::to_string(error) + " of twiddle/error.h", error);
}

// The link is at its end; say why, as soon as that is known.
void FrameLink::fail_ended(const std::string &otherwise)
{
    const Time end = steady_clock::now() + death_limit;
    std::string death = connection_->death();
    while (death.empty() && steady_clock::now() < end) {
        std::this_thread::sleep_for(milliseconds(5));
        death = connection_->death();
    }
    fail(death.empty() ? "has gone: " + otherwise : death);
}

} // namespace twiddle::link
