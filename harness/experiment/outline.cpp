#include "outline.hpp"

#include "record/csv.hpp"
#include "record/number_text.hpp"

#include <array>
#include <cmath>

namespace twiddle::experiment
{

namespace
{

constexpr int circle_segments = 72;
constexpr double turn_rad = 6.283185307179586;

// A closed circle about `centre`, spanned by the perpendicular radii `u` and `v`.
Polyline circle(const btVector3 &centre, const btVector3 &u, const btVector3 &v)
{
    Polyline points;
    for (int i = 0; i <= circle_segments; ++i) {
        const double angle_rad = turn_rad * (i % circle_segments) / circle_segments;
        points.push_back(centre + std::cos(angle_rad) * u + std::sin(angle_rad) * v);
    }
    return points;
}

std::vector<Polyline> sphere_outline(const sim::ObjectBody &body)
{
    const btVector3 x(body.radius_m, 0, 0);
    const btVector3 y(0, body.radius_m, 0);
    const btVector3 z(0, 0, body.radius_m);
    const btVector3 &centre = body.p_palm_centre_m;
    return {circle(centre, x, y), circle(centre, x, z), circle(centre, y, z)};
}

std::vector<Polyline> cylinder_outline(const sim::ObjectBody &body)
{
    const btVector3 x(body.radius_m, 0, 0);
    const btVector3 y(0, body.radius_m, 0);
    const btVector3 up(0, 0, body.height_m / 2);
    const btVector3 &centre = body.p_palm_centre_m;
    std::vector<Polyline> lines = {circle(centre - up, x, y), circle(centre + up, x, y)};
    for (const btVector3 &radius : {x, y, -x, -y}) {
        lines.push_back({centre - up + radius, centre + up + radius});
    }
    return lines;
}

std::vector<Polyline> cube_outline(const sim::ObjectBody &body)
{
    const double half_m = body.side_m / 2;
    const btVector3 up(0, 0, body.height_m / 2);
    const std::array<btVector3, 4> corners = {btVector3(half_m, half_m, 0), btVector3(-half_m, half_m, 0),
                                              btVector3(-half_m, -half_m, 0), btVector3(half_m, -half_m, 0)};
    Polyline bottom;
    Polyline top;
    std::vector<Polyline> lines;
    for (const btVector3 &corner : corners) {
        bottom.push_back(body.p_palm_centre_m - up + corner);
        top.push_back(body.p_palm_centre_m + up + corner);
        lines.push_back({bottom.back(), top.back()});
    }
    bottom.push_back(bottom.front());
    top.push_back(top.front());
    lines.push_back(bottom);
    lines.push_back(top);
    return lines;
}

const char *shape_name(sim::Shape shape)
{
    if (shape == sim::Shape::sphere) return "sphere";
    if (shape == sim::Shape::cylinder) return "cylinder";
    return "cube";
}

} // namespace

std::vector<Polyline> object_outline(const sim::ObjectBody &body)
{
    if (body.shape == sim::Shape::sphere) return sphere_outline(body);
    if (body.shape == sim::Shape::cylinder) return cylinder_outline(body);
    return cube_outline(body);
}

void write_outline(const std::filesystem::path &path, const std::vector<Polyline> &outline,
                   const std::vector<std::string> &comments)
{
    record::CsvWriter writer(path, comments, {"x_m", "y_m", "z_m"});
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (i > 0) writer.blank_line();
        for (const btVector3 &point_m : outline[i]) {
            writer.write(record::CsvRow().cell(point_m.x()).cell(point_m.y()).cell(point_m.z()));
        }
    }
    writer.finish();
}

std::vector<std::string> object_facts(const std::string &name, double size_m, const sim::ObjectBody &body)
{
    const btVector3 &centre_m = body.p_palm_centre_m;
    return {"object: " + name,
            std::string("object_shape: ") + shape_name(body.shape),
            "object_size_m: " + record::number_text(size_m),
            "object_height_m: " + record::number_text(body.height_m),
            "object_hinge_x_m: " + record::number_text(centre_m.x()),
            "object_hinge_y_m: " + record::number_text(centre_m.y()),
            "object_centre_z_m: " + record::number_text(centre_m.z())};
}

std::vector<std::string> fixed_facts(const settings::Setup &setup, const sim::ObjectBody &body)
{
    return {"object_rounding_m: " + record::number_text(body.rounding_m),
            "counted_direction: " + std::to_string(setup.object.counted_direction),
            "index_distal_deg: " + record::number_text(setup.hand.index_distal_deg),
            "thumb_distal_deg: " + record::number_text(setup.hand.thumb_distal_deg),
            "other_fingers_deg: " + record::number_text(setup.hand.other_fingers_deg)};
}

} // namespace twiddle::experiment
