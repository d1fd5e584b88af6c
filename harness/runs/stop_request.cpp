#include "stop_request.hpp"

#include <csignal>

namespace twiddle::runs
{

namespace
{

// The one thing that a signal handler may safely write.
volatile std::sig_atomic_t received_signal = 0;

void remember(int signal)
{
    received_signal = signal;
}

} // namespace

void catch_stop_signals()
{
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
}

int stop_signal()
{
    return received_signal;
}

} // namespace twiddle::runs
