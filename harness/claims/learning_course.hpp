// learning_course.hpp: how a run came to what it learned: how fast its rotation rose, and where its
// mixture of CPGs went.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace twiddle::claims
{

// Trials that are averaged before a learning curve is compared with a target: a fiftieth of the run, at least 1, at
// most 100. A single trial carries exploration noise, and the first lucky one is no learning.
std::size_t smoothing_trials(std::size_t trials);

// The first trial, counted from 1, at whose end the mean of the last smoothing_trials() rotations is at least
// `target_rad`; the number of trials if there is none. `rotation_rad` holds one value a trial, at least one.
std::size_t trials_to_reach(const std::vector<double> &rotation_rad, double target_rad);

// The shares of CPG-C, -M and -S in the joint outputs, 0 to 1, of sum 1.
using Mixture = std::array<double, 3>;

// The share of the outputs that would have to change hands to make one mixture the other, 0 to 1: half the sum of the
// absolute differences.
double mixture_distance(const Mixture &a, const Mixture &b);

// A run's mean mixtures; of the explored weights, whose noise the mean takes out.
struct MixtureCourse {
    Mixture last{}; // over the last mixture_trials, over all where there are fewer
    std::optional<Mixture>
        first; // over the first mixture_trials; these two only of runs of shortest_course trials and more
    std::optional<Mixture> middle; // over the mixture_trials after trial settled_trial
};

constexpr std::size_t mixture_trials = 500;
constexpr std::size_t settled_trial = 2000; // after which the paper calls the mixture stable
constexpr std::size_t shortest_course = settled_trial + 2 * mixture_trials;

// From the weights of CPG-C, -M and -S, one value a trial.
MixtureCourse mixture_course(const std::vector<double> &s_c, const std::vector<double> &s_m,
                             const std::vector<double> &s_s);

} // namespace twiddle::claims
