#include "object.hpp"

#include "urdf_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace twiddle::sim
{
namespace
{

constexpr double square_tolerance = 1e-9;

std::filesystem::path objects_dir(const std::filesystem::path &models_dir)
{
    return models_dir / "objects";
}

std::string list_of(const std::vector<std::string> &names)
{
    std::string list;
    for (const auto &name : names)
        list += (list.empty() ? "" : ", ") + name;
    return list.empty() ? "none" : list;
}

// The one collision shape of an object, at its origin.
const urdf::Geometry &geometry_of(const std::filesystem::path &path, const urdf::ModelInterface &model)
{
    const auto fail = [&path](const char *what) { throw std::runtime_error(path.string() + ": " + what); };
    const urdf::Link &link = *model.getRoot();
    if (!link.child_links.empty()) fail("an object must be one link");
    if (link.collision_array.size() != 1) fail("an object must have one <collision> shape");
    const urdf::Pose &origin = link.collision->origin;
    const double offset = std::abs(origin.position.x) + std::abs(origin.position.y) + std::abs(origin.position.z);
    if (offset > square_tolerance || 1 - std::abs(origin.rotation.w) > square_tolerance) {
        fail("the <collision> shape must be centred on the origin and not be turned, since the hinge is its z axis");
    }
    return *link.collision->geometry;
}

ObjectSpec spec_of(const std::filesystem::path &path, const urdf::Geometry &geometry)
{
    ObjectSpec spec;
    if (const auto *sphere = dynamic_cast<const urdf::Sphere *>(&geometry)) {
        spec.shape = Shape::sphere;
        spec.size_m = sphere->radius;
        spec.height_m = 2 * sphere->radius;
        return spec;
    }
    if (const auto *cylinder = dynamic_cast<const urdf::Cylinder *>(&geometry)) {
        spec.shape = Shape::cylinder;
        spec.size_m = cylinder->radius;
        spec.height_m = cylinder->length;
        return spec;
    }
    if (const auto *box = dynamic_cast<const urdf::Box *>(&geometry);
        box && std::abs(box->dim.x - box->dim.y) <= square_tolerance) {
        spec.shape = Shape::cube;
        spec.size_m = std::hypot(box->dim.x, box->dim.y);
        spec.height_m = box->dim.z;
        spec.side_m = box->dim.x;
        return spec;
    }
    throw std::runtime_error(path.string() +
                             ": the <collision> shape must be a sphere, a cylinder or a box with equal x and y sides");
}

} // namespace

ObjectSpec read_object(const std::filesystem::path &models_dir, const std::string &name)
{
    const auto known = object_names(models_dir);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        throw std::runtime_error("there is no object \"" + name + "\" in " + objects_dir(models_dir).string() +
                                 "; known objects: " + list_of(known));
    }
    const auto path = objects_dir(models_dir) / (name + ".urdf");
    ObjectSpec spec = spec_of(path, geometry_of(path, *read_urdf(path)));
    spec.name = name;
    if (!(spec.size_m > 0 && spec.height_m > 0))
        throw std::runtime_error(path.string() + ": the <collision> shape must have sizes above 0 m");
    return spec;
}

std::vector<std::string> object_names(const std::filesystem::path &models_dir)
{
    const auto dir = objects_dir(models_dir);
    if (!std::filesystem::is_directory(dir))
        throw std::runtime_error(dir.string() + ": there is no such folder of objects");
    std::vector<std::string> found;
    for (const auto &entry : std::filesystem::directory_iterator(dir)) {
        if (entry.path().extension() == ".urdf") found.push_back(entry.path().stem().string());
    }
    std::sort(found.begin(), found.end());
    std::vector<std::string> names;
    for (const char *size : {"small", "medium", "large"}) {
        for (const char *shape : {"sphere", "cylinder", "cube"}) {
            const auto at = std::find(found.begin(), found.end(), std::string(size) + "-" + shape);
            if (at == found.end()) continue;
            names.push_back(*at);
            found.erase(at);
        }
    }
    names.insert(names.end(), found.begin(), found.end());
    return names;
}

} // namespace twiddle::sim
