// learned_policy.hpp: what a run has learned, from the folder of a complete run.
#pragma once

#include "record/policy_json.hpp"
#include "record/run_json.hpp"
#include "run_folder.hpp"

namespace twiddle::runs
{

// The run in `folder`. Throws UsageError if it holds none.
record::Run run_in(const RunFolder &folder);

// The policy in `folder`, whose run is `specification`. Throws UsageError if there is none yet, std::runtime_error with
// one sentence if its parameters are not those of the run's model.
record::Policy learned_policy(const RunFolder &folder, const record::RunSpecification &specification);

// Refuse a policy whose learner is none of `specification`'s: other sizes, or a random state that no generator has.
// `folder` is named. Throws std::runtime_error with one sentence.
void require_learner(const RunFolder &folder, const record::RunSpecification &specification,
                     const record::Policy &policy);

} // namespace twiddle::runs
