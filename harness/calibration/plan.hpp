// plan.hpp: what a calibration does, from one file (experiments/calibrations/NAME.toml):
//
//     setup = "near"                   # optional: gives the settings that are not searched; else their defaults count
//     settings = { "object.cylinder_height_m" = 0.04 }   # optional: settings that are not searched, over these
//     seed = 1                         # of the search
//     objects = ["small-sphere"]       # compared with the paper; all other objects are held out
//     [screening]                      # many points, cheaply
//     trials = 800
//     seeds = 1
//     random = 200                     # points that fill the ranges by chance
//     refined = 100                    # points near one of the `parents` best so far
//     parents = 15
//     [finalists]                      # the best of them, in full
//     count = 20
//     trials = 5000
//     seeds = 4
//     [reach]                          # what hand and objects must meet (reach.hpp), deg
//     index_fei_deg = [25, 60]
//     index_aai_deg = [-15, 15]
//     thumb_fet_deg = [25, 60]
//     thumb_ot_deg = [40, 110]
//     [[variables]]                    # one block or more
//     setting = "object.coulomb_nm"    # or hand.natural_frequency_rad_s (search_space.hpp)
//     range = [0.0005, 0.01]
//     scale = "logarithmic"            # optional; "linear" otherwise
//     [[variables]]
//     setting = "object.counted_direction"
//     values = [-1, 1]
#pragma once

#include "reach.hpp"
#include "search.hpp"
#include "search_space.hpp"
#include "settings/setup.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::calibration
{

// The training that judges a point: `seeds` runs of `trials` trials a model and object.
struct Effort {
    std::uint32_t trials = 0;
    std::uint64_t seeds = 0;
};

struct CalibrationPlan {
    std::string name; // the file's, without .toml
    settings::Setup setup;
    std::vector<std::string> objects;
    SearchPlan search;
    Effort screening;
    Effort finals;
    std::size_t finalists = 0;
    ReachWindow reach;
    std::vector<Variable> variables;
};

// Read `path`; objects are those of `models_dir`, set-ups those of `setups_dir`. Throws std::runtime_error with one
// sentence that names file, line, key and what was expected.
CalibrationPlan read_calibration_plan(const std::filesystem::path &path, const std::filesystem::path &models_dir,
                                      const std::filesystem::path &setups_dir);

} // namespace twiddle::calibration
