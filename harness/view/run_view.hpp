// run_view.hpp: what a page shows of a run: the hand, the object, and how they moved in the replay of its policy.
#pragma once

#include "runs/run_folder.hpp"
#include "settings/joints.hpp"

#include <LinearMath/btTransform.h>

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace twiddle::view
{

// A capsule along +x of its frame, which turns about z.
struct LinkView {
    // Index into RunView::links; -1 is the palm.
    int parent = -1;
    // Index of the controlled joint that turns it; -1 if it is held.
    int joint = -1;
    double held_rad = 0;
    // The frame at angle 0, in the parent's; of a link on the palm, in the palm frame.
    btTransform X_parent_link = btTransform::getIdentity();
    double length_m = 0;
    double radius_m = 0;
};

// The object, which turns about palm +z through its centre.
struct ObjectView {
    std::string name;
    // "sphere", "cylinder" or "cube".
    std::string shape;
    // Radius of sphere and cylinder.
    double radius_m = 0;
    // Of a cube, its side.
    double height_m = 0;
    double rounding_m = 0;
    btVector3 p_palm_centre_m = btVector3(0, 0, 0);
    // 1: a positive rotation is counter-clockwise; -1: clockwise.
    int counted_direction = 1;
};

// A control step's end.
struct StepView {
    JointVector angle_rad{};
    btVector3 p_palm_index_tip_m = btVector3(0, 0, 0);
    btVector3 p_palm_thumb_tip_m = btVector3(0, 0, 0);
    double rotation_rad = 0;
    double index_force_n = 0;
    double thumb_force_n = 0;
};

struct RunView {
    std::string title;
    // What the run was: name and value.
    std::vector<std::pair<std::string, std::string>> facts;
    // The box of the palm, about its centre.
    btTransform X_palm_box = btTransform::getIdentity();
    btVector3 box_size_m = btVector3(0, 0, 0);
    std::vector<LinkView> links;
    ObjectView object;
    // Of step 1, 2, ...
    std::vector<StepView> steps;
};

// Read the run in `folder` from its run.json and trajectory.csv, with the hand of `models`. Throws UsageError if it
// holds no run or no trajectory, std::runtime_error with one sentence if the trajectory is not of this hand, or lacks
// what a page needs.
RunView read_run_view(const runs::RunFolder &folder, const std::filesystem::path &models);

} // namespace twiddle::view
