// stop_request.hpp: Ctrl-C as a request, so that a run can end between two trials.
#pragma once

namespace twiddle::runs
{

// From now on, SIGINT and SIGTERM are remembered instead of ending the program.
void catch_stop_signals();

// The signal that asked to stop; 0 if none did.
int stop_signal();

} // namespace twiddle::runs
