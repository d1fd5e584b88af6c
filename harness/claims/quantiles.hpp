// quantiles.hpp: quantiles of the distributions that intervals rest on.
#pragma once

namespace twiddle::claims
{

// Where Student's t of `degrees` degrees of freedom, > 0, has the share `share` of (0, 1) below it.
double student_quantile(double degrees, double share);

// The same for the standard normal distribution.
double normal_quantile(double share);

} // namespace twiddle::claims
