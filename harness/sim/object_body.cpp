#include "object_body.hpp"

namespace twiddle::sim
{

namespace
{

double hinge_inertia_kg_m2(const ObjectBody &body, double mass_kg)
{
    if (body.shape == Shape::sphere) return 0.4 * mass_kg * body.radius_m * body.radius_m;
    if (body.shape == Shape::cylinder) return 0.5 * mass_kg * body.radius_m * body.radius_m;
    return mass_kg * body.side_m * body.side_m / 6;
}

} // namespace

ObjectBody object_body(const ObjectSpec &spec, const settings::ObjectSetup &setup)
{
    ObjectBody body;
    body.shape = spec.shape;
    body.height_m = spec.height_m;
    body.p_palm_centre_m.setValue(setup.hinge_x_m, setup.hinge_y_m, setup.centre_z_m);
    if (spec.shape != Shape::cube) body.radius_m = spec.size_m;
    if (spec.shape == Shape::cylinder) body.height_m = setup.cylinder_height_m;
    if (spec.shape == Shape::cube) {
        const double scale = setup.cube_size == settings::CubeSize::half_diagonal ? 2 : 1;
        body.side_m = scale * spec.side_m;
        body.height_m = scale * spec.height_m;
    }
    if (spec.shape != Shape::sphere) body.rounding_m = setup.rounding_m;
    body.inertia_kg_m2 = hinge_inertia_kg_m2(body, setup.mass_kg);
    return body;
}

} // namespace twiddle::sim
