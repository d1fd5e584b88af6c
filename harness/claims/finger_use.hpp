// finger_use.hpp: what the two fingers do in a recorded trial: who turns the object, and how their sideways
// joints swing together.
#pragma once

#include <vector>

namespace twiddle::claims
{

// The share of the lesser finger in the object's forward turning, 0 (one finger does all) to 0.5 (both alike); 0
// if none turns it.
//
// One value a control step: the object's angle in the counted direction, from 0 at the start, and the normal force of
// each finger on it. A step's forward turn counts for the fingers that press on the object at its end, in proportion to
// their forces; what turns without a finger, or backwards, counts for none. Touching alone is thus no use, nor is
// holding the object still.
double lesser_finger_share(const std::vector<double> &object_rad, const std::vector<double> &index_contact_n,
                           const std::vector<double> &thumb_contact_n);

// The last part of a trial in which phases are compared, s: amplitudes and centres have settled by then.
constexpr double compared_s = 2;

// The distance in phase between the components of `a` and `b` at `frequency_hz` over the last compared_s, in turns: 0
// in phase, 0.5 opposite. The components are those of the least-squares fit of mean, cosine and sine, which asks for no
// whole number of periods.
double phase_distance_turns(const std::vector<double> &time_s, const std::vector<double> &a,
                            const std::vector<double> &b, double frequency_hz);

} // namespace twiddle::claims
