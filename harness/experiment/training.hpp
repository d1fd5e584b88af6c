// training.hpp: a training run, trial by trial.
#pragma once

#include "engine/engine.hpp"
#include "record/policy_json.hpp"
#include "record/run_json.hpp"
#include "trial.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace twiddle::experiment
{

// Trials of one training, at most.
constexpr std::uint32_t most_trials = 10'000'000;

// What `specification` asks for, from the files in `models_dir`. Throws std::runtime_error with one sentence.
TrialRunner make_trial_runner(const record::RunSpecification &specification, const std::filesystem::path &models_dir);

// One trial of a training run: a row of trials.csv.
struct TrialRow {
    std::uint32_t trial = 0; // from 1
    double rotation_rad = 0;
    // This and the numbers below are exactly what the library holds.
    double reward = 0;
    // The critic's estimate before the trial.
    double value = 0;
    // reward - value
    double td_error = 0;
    // Half-range of the exploration noise in force.
    double noise = 0;
    engine::ExpertWeights weight{};
    // As TrialResult's.
    std::string fault;
};

class Training
{
  public:
    // With an agent of the specification's number type in this process, or one that `make_agent` makes. Throws
    // std::runtime_error with one sentence.
    Training(const record::RunSpecification &specification, const std::filesystem::path &models_dir);
    Training(const record::RunSpecification &specification, const std::filesystem::path &models_dir,
             const engine::AgentMaker &make_agent);

    // Act, simulate, learn.
    TrialRow run_trial();

    // Act and learn from a rotation that an earlier, interrupted run of the same specification has recorded.
    TrialRow recall_trial(double rotation_rad);

    // What has been learned so far.
    record::Policy policy();

  private:
    // Start the coming trial: returns its row, as far as it is known.
    TrialRow act();
    void learn(TrialRow &row);

    std::string model_;
    bool with_centre_;
    const engine::Engine *engine_;
    TrialWorld world_;
    engine::LearnerInput input_;
    double reward_per_rad_ = 0;
    std::unique_ptr<engine::Agent> agent_;
    std::uint32_t trials_ = 0; // learned from
};

} // namespace twiddle::experiment
