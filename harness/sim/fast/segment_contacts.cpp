// The squared distance between a moving point and a convex core is convex along a line: half its derivative,
//     g(t) = (p(t) - nearest core point) . u,    p(t) = start + t u,
// never falls, and the closest point of the segment is g's root, held to 0..1. Both cores are products of simple ones
// (three slabs; a slab and a disc), so g is a sum of parts, each negative before the interval where the line is within
// its slab or disc, 0 in it and positive after. Where the intervals of all parts overlap, g is 0: over a face, beside
// the cylinder, or in the core. Else the root lies in the one gap between the last start and the first end of an
// interval, where it is a weighted mean (slabs) or the root of a function of known curvature (cylinder's rim).
#include "segment_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace twiddle::sim
{

namespace
{

constexpr double same_place_m = 1e-4;   // points of a segment that are closer are one contact
constexpr double in_core_m = 1e-12;     // a distance from the core that has no sure direction any more
constexpr double still_m2 = 1e-30;      // square of a length that counts as none: 1e-15 m
constexpr double endless = 1e30;        // end of an interval that is the whole line
constexpr double root_half = M_SQRT1_2; // upright part of a normal that leans by 45 degrees

// Part of a line, in shares of the segment. A point of a smooth minimum is an interval without length.
struct Interval {
    double from;
    double to;
};

constexpr Interval whole_line{-endless, endless};

// By value, unlike the standard library's: these become single instructions.
inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

inline double larger(double a, double b)
{
    return a > b ? a : b;
}

inline double held(double value, double from, double to)
{
    return smaller(larger(value, from), to);
}

inline double within_segment(double share)
{
    return held(share, 0, 1);
}

// What lies over a slab, -half..half: 0 in it.
double beyond(double coordinate, double half)
{
    return coordinate - held(coordinate, -half, half);
}

// Where on the line a coordinate is within a slab. The whole line, if the coordinate stays: then it has no part in g.
Interval within_slab(double start, double along, double half)
{
    if (along * along < still_m2) return whole_line;
    const double inverse = 1 / along;
    const double first = (-half - start) * inverse, second = (half - start) * inverse;
    return {smaller(first, second), larger(first, second)};
}

Interval overlap(const Interval &a, const Interval &b)
{
    return {larger(a.from, b.from), smaller(a.to, b.to)};
}

// A line from `start` along `u` beside a core; each kind has
//   closest()           the closest points of the segment, an interval of shares
//   clip(normal)        where the line is over the face that the normal belongs to; no interval if it is nowhere
//   gap(p)              from the nearest point of the core to p
//   way_out(p, normal)  for a point of the core: sets the normal, returns the distance from the core's surface,
//                       0 or less
struct LineAtBox {
    const RoundedCore &core;
    const Vector &start, &u;
    const std::array<Interval, 3> over; // each axis' slab

    LineAtBox(const RoundedCore &box, const Vector &from, const Vector &along)
        : core(box), start(from),
          u(along), over{within_slab(from.x, along.x, box.half_side_m), within_slab(from.y, along.y, box.half_side_m),
                         within_slab(from.z, along.z, box.half_height_m)}
    {
    }

    double half(int axis) const
    {
        return axis == 2 ? core.half_height_m : core.half_side_m;
    }

    Interval closest() const
    {
        const Interval all = overlap(overlap(over[0], over[1]), over[2]);
        if (all.from <= all.to) return {within_segment(all.from), within_segment(all.to)};
        // In the gap the axis whose slab starts last is still before it, and the one whose slab ends first is beyond:
        // both pull, with the squares of u as weights. The third pulls only if their balance is outside its slab.
        double weight = 0, pull = 0;
        for (int axis = 0; axis < 3; axis++) {
            const double before = over[axis].from == all.from ? u[axis] * u[axis] : 0;
            const double after = over[axis].to == all.to ? u[axis] * u[axis] : 0;
            weight += before + after;
            pull += before * all.from + after * all.to;
        }
        const double balance = pull / weight;
        pull = 0;
        for (int axis = 0; axis < 3; axis++)
            pull += u[axis] * u[axis] * held(balance, over[axis].from, over[axis].to);
        const double share = within_segment(pull / u.length2());
        return {share, share};
    }

    // The face is that of the normal's largest part. A segment along an edge that is over no face is clipped by the
    // edge's ends.
    Interval clip(const Vector &normal) const
    {
        const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
        const int face = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        const int one = face == 0 ? 1 : 0, other = face == 2 ? 1 : 2;
        const Interval both = overlap(over[one], over[other]);
        if (both.from < both.to) return both;
        return over[std::abs(normal[one]) < std::abs(normal[other]) ? one : other];
    }

    Vector gap(const Vector &p) const
    {
        return {beyond(p.x, core.half_side_m), beyond(p.y, core.half_side_m), beyond(p.z, core.half_height_m)};
    }

    double way_out(const Vector &p, Vector &normal) const
    {
        int face = 0;
        for (int axis = 1; axis < 3; axis++)
            if (std::abs(p[axis]) - half(axis) > std::abs(p[face]) - half(face)) face = axis;
        const double out = std::copysign(1, p[face]);
        normal = {face == 0 ? out : 0, face == 1 ? out : 0, face == 2 ? out : 0};
        return std::abs(p[face]) - half(face);
    }
};

struct LineAtCylinder {
    const RoundedCore &core;
    const Vector &start, &u;
    const double across2; // u's square in the plane of the base
    const double turning; // start x u in that plane: the line's distance from the axis is its size / root of across2
    const Interval over_height, over_disc;

    LineAtCylinder(const RoundedCore &cylinder, const Vector &from, const Vector &along)
        : core(cylinder), start(from), u(along), across2(along.x * along.x + along.y * along.y),
          turning(from.x * along.y - from.y * along.x),
          over_height(within_slab(from.z, along.z, cylinder.half_height_m)), over_disc(within_disc())
    {
    }

    // Where the line is over the disc. The point nearest the axis, an interval without length, if it passes the disc:
    // g's part is 0 there all the same.
    Interval within_disc() const
    {
        if (across2 < still_m2) return whole_line;
        const double inverse = 1 / across2, middle = -(start.x * u.x + start.y * u.y) * inverse;
        const double half2 = across2 * core.radius_m * core.radius_m - turning * turning;
        const double half = half2 > 0 ? std::sqrt(half2) * inverse : 0;
        return {middle - half, middle + half};
    }

    Interval closest() const
    {
        const Interval all = overlap(over_height, over_disc);
        if (all.from <= all.to) return {within_segment(all.from), within_segment(all.to)};
        if (all.to >= 1) return {1, 1};
        if (all.from <= 0) return {0, 0};
        const double share = closest_to_rim({larger(all.to, 0), smaller(all.from, 1)});
        return {share, share};
    }

    // The root of g in the gap between the two intervals, where the nearest core point is on a rim. There g rises, and
    // is convex if the line moves off the axis, concave if it comes nearer: Newton's steps, held to the gap, approach
    // from one side after the first one.
    double closest_to_rim(const Interval &gap) const
    {
        // Whether the line has left the slab before it comes over the disc, or comes into it after.
        const bool after = over_disc.from > over_height.to;
        const double rim_m = std::copysign(core.half_height_m, after ? u.z : -u.z);
        const double u2 = across2 + u.z * u.z, turning2 = turning * turning;
        // From where g would be 0, if its parts rose as they do at the ends of their intervals.
        const double disc_at = after ? over_disc.from : over_disc.to;
        const double slab_at = after ? over_height.to : over_height.from;
        const double disc_slope = larger(across2 - turning2 / (core.radius_m * core.radius_m), 0);
        const double slab_slope = u.z * u.z;
        const double balance = (disc_slope * disc_at + slab_slope * slab_at) / (disc_slope + slab_slope);
        double share = held(balance, gap.from, gap.to);
        for (int i = 0; i < 100; i++) {
            const double x = start.x + share * u.x, y = start.y + share * u.y, z = start.z + share * u.z;
            const double inverse = 1 / std::sqrt(x * x + y * y);
            const double pull = core.radius_m * inverse, rate = x * u.x + y * u.y;
            const double g = rate * (1 - pull) + u.z * (z - rim_m);
            const double slope = larger(across2 - pull * turning2 * inverse * inverse, 0) + slab_slope;
            const double next = held(share - g / slope, gap.from, gap.to);
            const double step = next - share;
            share = next;
            if (step * step * u2 < 1e-16) break;
        }
        return share;
    }

    // Cap or side, whichever the normal belongs to more.
    Interval clip(const Vector &normal) const
    {
        return std::abs(normal.z) < root_half ? over_height : over_disc;
    }

    Vector gap(const Vector &p) const
    {
        const double across_m2 = p.x * p.x + p.y * p.y, z = beyond(p.z, core.half_height_m);
        if (across_m2 <= core.radius_m * core.radius_m) return {0, 0, z};
        const double scale = 1 - core.radius_m / std::sqrt(across_m2);
        return {scale * p.x, scale * p.y, z};
    }

    double way_out(const Vector &p, Vector &normal) const
    {
        const double across_m = std::sqrt(p.x * p.x + p.y * p.y);
        const double side_m = across_m - core.radius_m, cap_m = std::abs(p.z) - core.half_height_m;
        if (cap_m >= side_m) {
            normal = {0, 0, std::copysign(1, p.z)};
            return cap_m;
        }
        normal = {1, 0, 0};
        if (across_m > in_core_m) normal = {p.x / across_m, p.y / across_m, 0};
        return side_m;
    }
};

// Contacts of one segment, as they are found.
template <class Line> class Collector
{
  public:
    Collector(const Line &line, double reach_m, SegmentContacts &contacts)
        : line_(line), reach_m_(reach_m), contacts_(contacts),
          same_share2_(same_place_m * same_place_m / larger(line.u.length2(), still_m2))
    {
    }

    // Returns how far the closest point is from the surface. It is a contact if it is in reach.
    double add_closest(const Interval &closest)
    {
        double share = closest.from;
        Vector gap = line_.gap(line_.start + line_.u * share);
        if (gap.length2() < in_core_m * in_core_m) {
            share = 0.5 * (closest.from + closest.to);
            gap = line_.gap(line_.start + line_.u * share);
        }
        add_point(share, gap, contact_closest);
        return contacts_.count > 0 ? contacts_.contact[0].distance_m
                                   : square_root(gap.length2()) - line_.core.rounding_m;
    }

    // A point that is no contact yet.
    void add(double share, int feature)
    {
        for (int i = 0; i < contacts_.count; i++) {
            SegmentContact &known = contacts_.contact[i];
            const double away = share - known.share;
            if (away * away >= same_share2_) continue;
            if (known.feature == contact_closest) known.feature = feature;
            return;
        }
        add_point(share, line_.gap(line_.start + line_.u * share), feature);
    }

    void add_clip(const Interval &clip)
    {
        if (!(clip.from < clip.to)) return;
        if (clip.from > 0 && clip.from < 1) add(clip.from, contact_first_clip);
        if (clip.to > 0 && clip.to < 1) add(clip.to, contact_second_clip);
    }

  private:
    void add_point(double share, const Vector &gap, int feature)
    {
        const double gap_m2 = gap.length2(), limit_m = reach_m_ + line_.core.rounding_m;
        if (gap_m2 >= limit_m * limit_m) return;
        const bool in_core = gap_m2 < in_core_m * in_core_m;
        const double gap_m = std::sqrt(gap_m2);
        SegmentContact *const contact = free_place(gap_m - line_.core.rounding_m);
        if (!contact) return;
        // Field by field: a copy of the whole would wait for its parts to reach memory.
        contact->share = share;
        contact->distance_m = gap_m - line_.core.rounding_m;
        contact->feature = feature;
        if (in_core) {
            contact->distance_m += line_.way_out(line_.start + line_.u * share, contact->normal);
        } else {
            const double inverse = 1 / gap_m;
            contact->normal = gap * inverse;
        }
    }

    // A place for one more contact: a new one, or else that of the farthest after the first, if it is farther.
    SegmentContact *free_place(double distance_m)
    {
        auto &all = contacts_.contact;
        if (contacts_.count < static_cast<int>(all.size())) return &all[contacts_.count++];
        SegmentContact *const farthest =
            std::max_element(all.begin() + 1, all.end(), [](const SegmentContact &a, const SegmentContact &b) {
                return a.distance_m < b.distance_m;
            });
        return farthest->distance_m > distance_m ? farthest : nullptr;
    }

    const Line &line_;
    const double reach_m_;
    SegmentContacts &contacts_;
    const double same_share2_; // square of the shares' difference up to which points are the same
};

template <class Line> double collect(const Line &line, double reach_m, SegmentContacts &contacts)
{
    Collector<Line> collector(line, reach_m, contacts);
    const double distance_m = collector.add_closest(line.closest());
    if (contacts.count == 0) return distance_m;
    const Vector &normal = contacts.contact[0].normal;
    collector.add(0, contact_start);
    collector.add(1, contact_end);
    collector.add_clip(line.clip(normal));
    return distance_m;
}

double collect_at_ball(const RoundedCore &ball, const Vector &start, const Vector &u, double reach_m,
                       SegmentContacts &contacts)
{
    const double u2 = u.length2(), limit_m = reach_m + ball.rounding_m;
    const double share = u2 < still_m2 ? 0 : within_segment(-start.dot(u) / u2);
    const Vector p = start + u * share;
    const double away_m2 = p.length2();
    const double away_m = std::sqrt(away_m2);
    if (away_m >= limit_m) return away_m - ball.rounding_m;
    const Vector normal = away_m < in_core_m ? Vector{1, 0, 0} : p * (1 / away_m);
    contacts.contact[0] = {share, normal, away_m - ball.rounding_m, contact_closest};
    contacts.count = 1;
    return away_m - ball.rounding_m;
}

// How far the box around the segment is from the box around the object; 0 or less where they overlap.
double distance_of_boxes_m(const RoundedCore &core, const Vector &start, const Vector &end)
{
    const double across_m = core.radius_m + core.half_side_m + core.rounding_m;
    const double along_m = core.half_height_m + core.rounding_m;
    const auto beyond_m = [](double a, double b, double half) { return larger(smaller(a, b), -larger(a, b)) - half; };
    return larger(larger(beyond_m(start.x, end.x, across_m), beyond_m(start.y, end.y, across_m)),
                  beyond_m(start.z, end.z, along_m));
}

} // namespace

RoundedCore rounded_core(const ObjectBody &body)
{
    RoundedCore core;
    core.shape = body.shape;
    if (body.shape == Shape::sphere) {
        core.rounding_m = core.bounding_radius_m = body.radius_m;
        return core;
    }
    core.rounding_m = body.rounding_m;
    core.half_height_m = body.height_m / 2 - body.rounding_m;
    if (body.shape == Shape::cylinder) {
        core.radius_m = body.radius_m - body.rounding_m;
        core.bounding_radius_m = body.radius_m;
        return core;
    }
    core.half_side_m = body.side_m / 2 - body.rounding_m;
    core.bounding_radius_m = std::sqrt(2) * core.half_side_m + body.rounding_m;
    return core;
}

double find_segment_contacts(const RoundedCore &core, const Vector &start_m, const Vector &end_m, double reach_m,
                             SegmentContacts &contacts)
{
    contacts.count = 0;
    const Vector u = end_m - start_m;
    if (core.shape == Shape::sphere) return collect_at_ball(core, start_m, u, reach_m, contacts);
    // A box that is far off says enough, for less.
    const double boxes_m = distance_of_boxes_m(core, start_m, end_m);
    if (boxes_m > 2 * reach_m) return boxes_m;
    if (core.shape == Shape::cylinder) return collect(LineAtCylinder(core, start_m, u), reach_m, contacts);
    return collect(LineAtBox(core, start_m, u), reach_m, contacts);
}

} // namespace twiddle::sim
