// press.hpp: control steps in which a chosen number of fingers rests against the object.
#pragma once

#include "work.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace twiddle::bench
{

// Random postures, each held for a trial, of which 20 count: those in which just `fingers` fingers touch the object at
// the end of every control step of the trial's second half. For no fingers the object is out of reach.
class Press
{
  public:
    // Tries up to 2,000 postures, the same for the same seed. Throws std::runtime_error if none of them counts.
    Press(const std::string &object, int fingers, const std::vector<settings::Override> &overrides, std::uint32_t seed);

    // Control steps a second of the trials' second halves, of whole passes for at least `seconds` in all.
    double steps_per_s(double seconds);

    // Postures.
    std::size_t tried() const
    {
        return tried_;
    }
    std::size_t counted() const
    {
        return counted_.size();
    }

  private:
    bool counts(const engine::Parameters &posture, int fingers);

    experiment::TrialRunner runner_;
    std::size_t tried_ = 0;
    std::vector<engine::Parameters> counted_;
};

} // namespace twiddle::bench
