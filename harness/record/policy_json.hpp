// policy_json.hpp: policy.json, what a run has learned: the parameters to replay, and the learner's
// state to go on from.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace twiddle::record
{

struct Policy {
    std::string model;        // e.g. "cpg-c"
    bool centre = true;       // oscillators have a centre parameter
    std::uint32_t trials = 0; // learned from
    std::vector<std::pair<std::string, double>>
        parameters; // without noise, in (0, 1): name ("cpg-c.amplitude-1") and value, in order
    std::vector<std::vector<double>> actor_weights; // [units][inputs]
    std::vector<double> critic_weights;             // [inputs]
    std::array<std::uint32_t, 4> random_state{};    // of the generator of exploration noise and initial weights
};

void write_policy(const std::filesystem::path &path, const Policy &policy);

// Read a policy.json. Throws std::runtime_error with one sentence that names the file, the key and what was expected.
Policy read_policy(const std::filesystem::path &path);

} // namespace twiddle::record
