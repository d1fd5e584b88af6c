// models.hpp: the learning models by name, and the names of their parameters.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace twiddle::engine
{

// "cpg-s", "cpg-m", "cpg-c", "cpg-h".
std::vector<std::string> model_names();

// One name a parameter, in the order of the C library's model.h: "cpg-c.frequency", "cpg-c.amplitude-1",
// "cpg-c.centre-1", "cpg-c.phase-lag-1-2", "selector.cpg-c". Oscillators count from 1. Throws std::invalid_argument,
// which lists the known models, for another.
std::vector<std::string> parameter_names(const std::string &model, bool with_centre);

// How many there are. Throws as parameter_names().
std::size_t parameter_count(const std::string &model, bool with_centre);

// Units of the learner's input map.
std::size_t input_count();

} // namespace twiddle::engine
