// made_up_runs.hpp: runs with chosen measures, to work claims out by hand.
#pragma once

#include "claims/run_grid.hpp"

#include <vector>

namespace twiddle::test
{

// Runs of one cell with these final rotations, in rad.
inline claims::Runs runs_of(const std::vector<double> &rotation_rad)
{
    claims::Runs runs;
    for (const double value : rotation_rad) {
        claims::RunMeasures run;
        run.folder = "run-" + std::to_string(runs.size() + 1);
        run.final_rotation_rad = value;
        runs.push_back(run);
    }
    return runs;
}

} // namespace twiddle::test
