// memory.hpp: what the simulation takes of memory. Each number comes from a process of its own, which is forked from
// this one; ask before this one has grown, since the child starts with what its parent holds.
#pragma once

#include "sim/world.hpp"

#include <cstdint>
#include <string>

namespace twiddle::bench
{

// The peak of the resident memory of a process that does one training run of CPG-H, in MB.
double training_peak_mb(sim::Stepper stepper, const std::string &object, std::uint32_t trials);

// What one more worker in a process, a world and its controller, adds to the resident memory, in MB: the mean of 16
// after the first.
double further_worker_mb(sim::Stepper stepper, const std::string &object);

} // namespace twiddle::bench
