// frame_link.hpp: requests to a chip and its answers, over a connection that may be silent, noisy or dead
// (docs/PROTOCOL.md).
#pragma once

#include "agent/frame.h"
#include "agent/messages.h"
#include "connection.hpp"

#include <chrono>
#include <cstdint>
#include <memory>

namespace twiddle::link
{

// How long a chip may take to answer a request, and to come to life after its start.
constexpr std::chrono::milliseconds answer_limit{3000};
constexpr std::chrono::milliseconds start_limit{4000};

// The library on the chip refuses what it was asked for.
class LibraryRefusal : public LinkError
{
  public:
    // `error` is its enum twd_error.
    LibraryRefusal(const std::string &sentence, int error) : LinkError(sentence), error_(error)
    {
    }
    int error() const
    {
        return error_;
    }

  private:
    int error_;
};

class FrameLink
{
  public:
    explicit FrameLink(std::unique_ptr<Connection> connection);

    // Say hello until the chip answers, whatever came before; returns the answer to TWD_REQUEST_HELLO. Throws
    // LinkError.
    const twd_frame &greet();

    // Send `request`, whose payload the caller has written, and wait for its answer. Throws LinkError for a chip that
    // is silent, damages frames, or refuses the request; LibraryRefusal if it is the library that does.
    const twd_frame &ask(twd_request type, twd_frame &request);

    // The chip in a sentence.
    std::string name() const;

  private:
    using Time = std::chrono::steady_clock::time_point;

    void send(twd_request type, twd_frame &request, Time deadline);
    void write(const std::uint8_t *bytes, std::size_t count, Time deadline);
    twd_frame_found next(Time deadline); // TWD_FRAME_NONE at the deadline
    bool read_some(Time deadline);       // false at the deadline
    [[noreturn]] void fail(const std::string &rest) const;
    [[noreturn]] void fail_refused() const;
    [[noreturn]] void fail_ended(const std::string &otherwise);

    std::unique_ptr<Connection> connection_;
    twd_frame_reader reader_{};
    twd_frame answer_{};
    std::uint8_t sequence_ = 0;
};

} // namespace twiddle::link
