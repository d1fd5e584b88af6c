// contact_finder.hpp: the contacts of both fingers with the object, as rows for the solver.
//
// Most capsules are far from touching in most substeps. The finder knows how far each was when it was looked at last,
// and how far it can have come since; it looks again when that may matter.
#pragma once

#include "constraint_search.hpp"
#include "contact_solver.hpp"
#include "finger_kinematics.hpp"
#include "lanes.hpp"
#include "segment_contacts.hpp"
#include "sim/object_body.hpp"

#include <vector>

namespace twiddle::sim
{

// Both fingers in lanes, and the object, at the start of a substep.
struct Motion {
    std::array<SineCosineOf<Pair>, 2> angle;
    FingerVectorOf<Pair> velocity_rad_s{};      // that led here, over the last substep
    FingerVectorOf<Pair> free_velocity_rad_s{}; // of the substep without contacts
    double object_rad = 0;
    double object_rad_s = 0; // that led here
};

class ContactFinder
{
  public:
    // Contacts are made `breaking_threshold_m` before they touch; a penetration is corrected by the share
    // `error_reduction`.
    ContactFinder(const std::array<FingerKinematics, 2> &fingers, const ObjectBody &object, double breaking_threshold_m,
                  double error_reduction, double substep_s);

    // Forget how far the capsules were: what moves next did not come from where it was.
    void reset();

    // Fill `contacts` for fingers of `mass` and object in `motion`, which follows that of the last call. A contact that
    // the velocities `free` (of the substep without contacts) carry far from touching is left out.
    void find(const Motion &motion, const MassFactorOf<Pair> &mass, const Velocities &free, Contacts &contacts);

    // Whitened velocity of the object for an angular velocity of 1 rad/s: the square root of its inertia.
    double whitening() const
    {
        return whitening_;
    }

  private:
    // A capsule of a finger, in the frame of the joint that carries it.
    struct Capsule {
        int joint;
        Vector start_m, end_m;
        double radius_m;
        double due_m; // looked at when this much has been travelled
    };
    struct Finger {
        Vector origin_m, axis; // of the first joint
        std::vector<Capsule> capsules;
        double due_m = 0; // the least of its capsules'
    };
    // What one finger's contacts have in common.
    struct Scene;

    // Look at the capsules of a finger that are due.
    void look(const Scene &scene, Finger &finger, double limit_m, Contacts &contacts) const;
    // Look at one capsule, whose features are numbered from `first_feature`.
    void look_at(const Scene &scene, Capsule &capsule, int first_feature, Contacts &contacts) const;
    std::array<Vector, 2> ends_m(const Scene &scene, const Capsule &capsule) const;
    void add_contact(const Scene &scene, const Capsule &capsule, const Vector &p_axis_m, const SegmentContact &place,
                     const Vector &normal, int feature, Contacts &contacts) const;

    std::array<FingerKinematics, 2> kinematics_;
    PairKinematics pair_kinematics_;
    std::array<Finger, 2> finger_;
    RoundedCore core_;
    double whitening_;
    double inverse_whitening_;
    double breaking_threshold_m_;
    double error_reduction_;
    double substep_s_;
    // What a rad/s of the joints, in lanes, and of the object moves a point of finger or object in a
    // substep at most, m.
    FingerVectorOf<Pair> stride_m_;
    double object_stride_m_;
    // How far finger and object have come towards each other since reset() at most, m.
    Pair travelled_m_{};
};

} // namespace twiddle::sim
