// skill_header.hpp: a trained run as a C header for firmware: the skill (twiddle/skill.h), and the learner's snapshot
// (twiddle/learner.h).
#pragma once

#include "record/policy_json.hpp"
#include "record/run_json.hpp"

#include <filesystem>
#include <string>

namespace twiddle::engine
{

// The names in a run's header begin with this unless told otherwise, e.g. "small_sphere_cpg_h_no_centre".
std::string skill_name(const record::RunSpecification &specification);

// The header's text: C99, C++ as well, for any number build. Its names begin with `name`, which record::is_c_name.
// `policy` is what the run of `specification` has learned, as long as its model wants it; objects are those of
// `models_dir`. Throws std::runtime_error for an object that is not there.
std::string skill_header(const std::string &name, const record::RunSpecification &specification,
                         const record::Policy &policy, const std::filesystem::path &models_dir);

} // namespace twiddle::engine
