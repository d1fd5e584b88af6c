// claim_measures.hpp: the measure behind each part of the paper's claims, on a sweep's runs or on the
// paper's own tables.
//
// Each takes what cells there are: an object without all cells that a measure compares is left out of it. Cells
// are with centre unless a measure says otherwise; "rotation" is a run's final rotation. claims.cpp has the
// measures in words.
#pragma once

#include "estimate.hpp"

namespace twiddle::claims
{

// 1: mean rotation of CPG-H with minus without centre, on every object.
Estimate centre_gain(const RunGrid &grid);

// 2a, 2b: share of the objects with all four models on which CPG-H has the highest mean rotation, the
// highest single run.
Estimate objects_won_by_mean(const RunGrid &grid);
Estimate objects_won_by_best(const RunGrid &grid);

// 3a, 3b: against every single model: mean over the objects of log2 (its trials to 80 % / CPG-H's), of the difference
// in mean rotation over all trials.
Estimate doublings_faster(const RunGrid &grid);
Estimate area_gain(const RunGrid &grid);

// 4a, 4b: mean over shapes and models of the rotation on the smaller minus that on the larger object.
Estimate small_over_medium(const RunGrid &grid);
Estimate medium_over_large(const RunGrid &grid);

// 5a, 5b: mean over sizes and models of the rotation on the first minus that on the second shape.
Estimate sphere_over_cylinder(const RunGrid &grid);
Estimate cylinder_over_cube(const RunGrid &grid);

// 6a, 6c: the lesser finger's share of the forward turning on the small sphere, of CPG-H, of every single model. 6b:
// CPG-H's phase distance of AAI and OT there.
Estimate lesser_share_of_h(const RunGrid &grid);
Estimate sideways_phase_of_h(const RunGrid &grid);
Estimate lesser_share_of_singles(const RunGrid &grid);

// 7a: what CPG-H's largest weight leaves to the other two. 7b: the way of its mixture before trial 2,000 minus that
// after. 7c: the difference in rotation of two runs on one object, weighted with the distance of their mixtures, over
// the mean rotation there.
Estimate weight_of_lesser(const RunGrid &grid);
Estimate mixture_settling(const RunGrid &grid);
Estimate score_difference_of_mixtures(const RunGrid &grid);

// 8a, 8b: mean absolute difference of the frequencies of two models' runs on one object, as a share of the learnable
// range: CPG-C and CPG-H; each of those with each of CPG-M and CPG-S.
Estimate frequency_difference_learned(const RunGrid &grid);
Estimate frequency_difference_set(const RunGrid &grid);

// 9: centre_gain on the small objects minus that on the large ones, means over the shapes.
Estimate centre_gain_small_over_large(const RunGrid &grid);

// 10a: (sd of CPG-H - sd of a single model) / (their sum), mean over objects and single models. 10b: mean rotation of
// CPG-C minus that of every other model on every large object. 10c: of CPG-M on the medium cube.
Estimate spread_of_h(const RunGrid &grid);
Estimate lead_of_c_on_large(const RunGrid &grid);
Estimate lead_of_m_on_medium_cube(const RunGrid &grid);

} // namespace twiddle::claims
