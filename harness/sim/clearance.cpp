#include "clearance.hpp"

#include <ccd/ccd.h>
#include <ccd/quat.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace twiddle::sim
{

namespace
{

struct CapsuleShape {
    btVector3 start_m;
    btVector3 end_m;
    double radius_m;
};

struct PlacedObject {
    const ObjectBody *body;
    btMatrix3x3 rotation;
};

btVector3 from_ccd(const ccd_vec3_t *v)
{
    return {v->v[0], v->v[1], v->v[2]};
}

void to_ccd(const btVector3 &from, ccd_vec3_t *to)
{
    ccdVec3Set(to, from.x(), from.y(), from.z());
}

void capsule_support(const void *shape, const ccd_vec3_t *direction, ccd_vec3_t *point)
{
    const auto &capsule = *static_cast<const CapsuleShape *>(shape);
    const btVector3 d = from_ccd(direction).normalized();
    const btVector3 &end = d.dot(capsule.end_m - capsule.start_m) > 0 ? capsule.end_m : capsule.start_m;
    to_ccd(end + capsule.radius_m * d, point);
}

void capsule_centre(const void *shape, ccd_vec3_t *centre)
{
    const auto &capsule = *static_cast<const CapsuleShape *>(shape);
    to_ccd((capsule.start_m + capsule.end_m) / 2, centre);
}

// Support of the object without its rounding, in its own frame.
btVector3 core_support(const ObjectBody &body, const btVector3 &d)
{
    if (body.shape == Shape::sphere) return {0, 0, 0};
    const double half_height_m = body.height_m / 2 - body.rounding_m;
    const double z_m = std::copysign(half_height_m, d.z());
    if (body.shape == Shape::cube) {
        const double half_side_m = body.side_m / 2 - body.rounding_m;
        return {std::copysign(half_side_m, d.x()), std::copysign(half_side_m, d.y()), z_m};
    }
    const double across = std::hypot(d.x(), d.y());
    const double radius_m = body.radius_m - body.rounding_m;
    if (across < 1e-12) return {0, 0, z_m};
    return {radius_m * d.x() / across, radius_m * d.y() / across, z_m};
}

void object_support(const void *shape, const ccd_vec3_t *direction, ccd_vec3_t *point)
{
    const auto &object = *static_cast<const PlacedObject *>(shape);
    const btVector3 d_object = object.rotation.transpose() * from_ccd(direction).normalized();
    const double ball_m = object.body->shape == Shape::sphere ? object.body->radius_m : object.body->rounding_m;
    const btVector3 p_object = core_support(*object.body, d_object) + ball_m * d_object;
    to_ccd(object.body->p_palm_centre_m + object.rotation * p_object, point);
}

void object_centre(const void *shape, ccd_vec3_t *centre)
{
    to_ccd(static_cast<const PlacedObject *>(shape)->body->p_palm_centre_m, centre);
}

// Distance between segments a0-a1 and b0-b1: the interior solution where there is one, else the nearest end point.
double segment_distance_m(const btVector3 &a0, const btVector3 &a1, const btVector3 &b0, const btVector3 &b1)
{
    const btVector3 u = a1 - a0, v = b1 - b0, w = a0 - b0;
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
    const double determinant = uu * vv - uv * uv;
    double s = determinant > 1e-18 ? std::clamp((uv * vw - vv * uw) / determinant, 0.0, 1.0) : 0.0;
    const double t = std::clamp((uv * s + vw) / vv, 0.0, 1.0);
    s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
    return (w + s * u - t * v).length();
}

} // namespace

std::optional<Overlap> capsule_overlap(const ObjectBody &object, double angle_rad, const btVector3 &start_m,
                                       const btVector3 &end_m, double radius_m)
{
    const CapsuleShape capsule{start_m, end_m, radius_m};
    const PlacedObject placed{&object, btMatrix3x3(btQuaternion(btVector3(0, 0, 1), angle_rad))};
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = object_support;
    ccd.support2 = capsule_support;
    ccd.center1 = object_centre;
    ccd.center2 = capsule_centre;
    ccd.mpr_tolerance = 1e-7;
    ccd.max_iterations = 1000;
    ccd_real_t depth = 0;
    ccd_vec3_t direction, position;
    if (ccdMPRPenetration(&placed, &capsule, &ccd, &depth, &direction, &position) != 0) return std::nullopt;
    return Overlap{depth, from_ccd(&direction)};
}

void require_clearance(const ArticulatedHand &hand, const ObjectBody &object, const std::string &object_name)
{
    for (int i = 0; i < static_cast<int>(hand.links().size()); i++) {
        const auto ends_m = hand.p_palm_capsule_m(i);
        const auto overlap = capsule_overlap(object, 0, ends_m[0], ends_m[1], hand.capsule(i).radius_m);
        if (!overlap) continue;
        char depth_mm[32];
        std::snprintf(depth_mm, sizeof depth_mm, "%.2f mm", 1e3 * overlap->depth_m);
        throw std::runtime_error("the straight hand's link " + hand.model().links[hand.links()[i].model_link].name +
                                 " reaches " + depth_mm + " into " + object_name +
                                 ": move the hinge with [object] hinge_x_m, hinge_y_m or centre_z_m");
    }
}

double finger_clearance_m(const ArticulatedHand &hand)
{
    double smallest_m = 1;
    for (int i = 0; i < static_cast<int>(hand.links().size()); i++) {
        if (hand.links()[i].finger != Finger::index) continue;
        const auto index_m = hand.p_palm_capsule_m(i);
        for (int t = 0; t < static_cast<int>(hand.links().size()); t++) {
            if (hand.links()[t].finger != Finger::thumb) continue;
            const auto thumb_m = hand.p_palm_capsule_m(t);
            const double radii_m = hand.capsule(i).radius_m + hand.capsule(t).radius_m;
            smallest_m =
                std::min(smallest_m, segment_distance_m(index_m[0], index_m[1], thumb_m[0], thumb_m[1]) - radii_m);
        }
    }
    return smallest_m;
}

} // namespace twiddle::sim
