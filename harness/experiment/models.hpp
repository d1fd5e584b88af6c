// models.hpp: the learning models by name, and the names of their parameters.
#pragma once

#include "number.hpp"

#include <twiddle/model.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace twiddle::experiment
{

// "cpg-s", "cpg-m", "cpg-c", "cpg-h".
std::vector<std::string> model_names();

// Throws std::invalid_argument that lists the known names.
const twd_model &find_model(const std::string &name);

// What the library calls one of these models, e.g. "twd_model_h".
std::string c_name(const twd_model &model);

// One name a parameter, in the order of model.h: "cpg-c.frequency", "cpg-c.amplitude-1", "cpg-c.centre-1",
// "cpg-c.phase-lag-1-2", "selector.cpg-c". Oscillators count from 1.
std::vector<std::string> parameter_names(const twd_model &model, bool with_centre);

// The share of each CPG in the joint outputs, in the order C, M, S. They sum to 1.
constexpr std::size_t expert_count = 3;
using ExpertWeights = std::array<Shown, expert_count>;

// The weights of `model`'s own CPGs, as the controller holds them, spread over all three; absent ones are 0.
ExpertWeights expert_weights(const twd_model &model, const twd_num *weight);

} // namespace twiddle::experiment
