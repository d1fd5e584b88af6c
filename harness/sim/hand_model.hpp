// hand_model.hpp: the hand as its URDF describes it, constant and free of any set-up.
#pragma once

#include <LinearMath/btMatrix3x3.h>
#include <LinearMath/btTransform.h>

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::sim
{

// A capsule from its link's origin along the link's +x axis.
struct Capsule {
    double length_m = 0; // between the centres of its two end spheres
    double radius_m = 0;
};

// One link, and the joint by which it hangs on its parent. Joints turn about the z axis of the link's frame.
struct HandLink {
    std::string name;      // e.g. "hand_index_0"
    std::string joint;     // e.g. "index_0"
    int parent = -1;       // index into HandModel::links; -1 is the palm
    bool revolute = false; // false: fixed in the URDF (middle_0)
    double lower_rad = 0;  // joint range
    double upper_rad = 0;
    btTransform X_parent_joint; // the link's frame at angle 0, in the parent link's frame
    double mass_kg = 0;
    btVector3 p_link_com_m;    // centre of mass in the link's frame
    btMatrix3x3 inertia_kg_m2; // about the centre of mass, along the link's axes, without any reflected inertia
    Capsule capsule;
};

// The hand: the palm ("hand", the root) and the links that hang on it, parents before children.
struct HandModel {
    std::string name;
    std::string root; // the palm's link name
    std::vector<HandLink> links;
    // The palm frame of all reported positions, in the root's frame: the hand's Denavit-Hartenberg frame, which the
    // URDF has as the massless link "palm". +x is distal, +y ulnar, +z out of the palm.
    btTransform X_hand_palm = btTransform::getIdentity();
    // The box that the palm is drawn as, about its centre in the root's frame; without size if the URDF has none.
    btTransform X_hand_box = btTransform::getIdentity();
    btVector3 box_size_m = btVector3(0, 0, 0);

    // Index of the link that `joint` moves. Throws std::out_of_range with the joint's name.
    int link_of_joint(const std::string &joint) const;
    // 21 for the iCub hand: the palm counts.
    int link_count() const;
    // 19 for the iCub hand.
    int dof_count() const;
};

// Read `path`. Throws std::runtime_error with one sentence that names the file, the link and what was expected.
HandModel read_hand_model(const std::filesystem::path &path);

} // namespace twiddle::sim
