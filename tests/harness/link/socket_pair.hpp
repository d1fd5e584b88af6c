// socket_pair.hpp: both ends of a link within this process.
#pragma once

#include "link/connection.hpp"
#include "record/descriptor.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/socket.h>

namespace twiddle::test
{

class SocketPair
{
  public:
    SocketPair()
    {
        std::array<int, 2> ends{};
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
            throw std::runtime_error("cannot make a pair of sockets");
        ours_ = record::Descriptor(ends[0]);
        chips_ = record::Descriptor(ends[1]);
        ::fcntl(ours_.number(), F_SETFL, O_NONBLOCK);
    }

    // The harness's end, which does not block, and the chip's, which does.
    int ours() const
    {
        return ours_.number();
    }
    int chips() const
    {
        return chips_.number();
    }
    void close_ours()
    {
        ours_ = record::Descriptor();
    }
    void close_chips()
    {
        chips_ = record::Descriptor();
    }

  private:
    record::Descriptor ours_;
    record::Descriptor chips_;
};

// The harness's end as the connection to "the chip", which is known to be dead if `death` says so.
class SocketConnection : public link::Connection
{
  public:
    explicit SocketConnection(const SocketPair &pair, std::string death = "") : pair_(pair), death_(std::move(death))
    {
    }
    std::string name() const override
    {
        return "the chip";
    }
    int input() const override
    {
        return pair_.ours();
    }
    int output() const override
    {
        return pair_.ours();
    }
    std::string death() override
    {
        return death_;
    }

  private:
    const SocketPair &pair_;
    std::string death_;
};

} // namespace twiddle::test
