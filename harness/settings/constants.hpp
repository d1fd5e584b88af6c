// constants.hpp: the numbers that several rooms share and no set-up changes.
#pragma once

namespace twiddle
{

// Of a tick of the pattern generators; the paper's.
constexpr double control_step_s = 0.01;

// Control steps of a trial; the paper's.
constexpr int trial_steps = 300;

constexpr double rad_per_deg = 3.14159265358979323846 / 180;

} // namespace twiddle
