#include "hand_model.hpp"

#include "urdf_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace twiddle::sim
{
namespace
{

constexpr double frame_tolerance = 1e-9; // m and dimensionless: well above what decimal numbers in a file lose

// Where an error was found.
struct Place {
    const std::filesystem::path &path;
    const std::string &link;

    [[noreturn]] void fail(const std::string &what) const
    {
        throw std::runtime_error(path.string() + ": link \"" + link + "\" " + what);
    }
};

btVector3 vector_of(const urdf::Vector3 &vector)
{
    return {vector.x, vector.y, vector.z};
}

btMatrix3x3 matrix_of(const urdf::Rotation &rotation)
{
    return btMatrix3x3(btQuaternion(rotation.x, rotation.y, rotation.z, rotation.w));
}

bool near(const btVector3 &a, const btVector3 &b)
{
    return (a - b).length() <= frame_tolerance;
}

void read_joint(const Place &place, const urdf::Joint &joint, HandLink &link)
{
    link.joint = joint.name;
    const auto &origin = joint.parent_to_joint_origin_transform;
    link.X_parent_joint = btTransform(matrix_of(origin.rotation), vector_of(origin.position));
    if (joint.type == urdf::Joint::FIXED) return;
    const std::string name = "hangs on joint \"" + joint.name + "\", which ";
    if (joint.type != urdf::Joint::REVOLUTE) place.fail(name + "is neither revolute nor fixed");
    if (!near(vector_of(joint.axis), btVector3(0, 0, 1))) place.fail(name + "does not turn about its z axis (0 0 1)");
    if (!joint.limits) place.fail(name + "has no limits");
    if (!(joint.limits->lower < joint.limits->upper)) place.fail(name + "has no range: lower must be below upper");
    link.revolute = true;
    link.lower_rad = joint.limits->lower;
    link.upper_rad = joint.limits->upper;
}

void read_inertial(const Place &place, const urdf::Link &source, HandLink &link)
{
    const auto &inertial = source.inertial;
    if (!inertial) place.fail("has no <inertial>; mass, centre of mass and inertia are needed");
    if (!(inertial->mass > 0)) place.fail("has a mass that is not above 0 kg");
    link.mass_kg = inertial->mass;
    link.p_link_com_m = vector_of(inertial->origin.position);
    const btMatrix3x3 along_inertial(inertial->ixx, inertial->ixy, inertial->ixz, inertial->ixy, inertial->iyy,
                                     inertial->iyz, inertial->ixz, inertial->iyz, inertial->izz);
    const btMatrix3x3 R_link_inertial = matrix_of(inertial->origin.rotation);
    link.inertia_kg_m2 = R_link_inertial * along_inertial * R_link_inertial.transpose();
    if (!(inertial->ixx > 0 && inertial->iyy > 0 && inertial->izz > 0)) {
        place.fail("has a moment of inertia that is not above 0 kg m2");
    }
}

// A URDF has no capsule: the one of a finger link is a cylinder along x with a sphere at either end.
void read_capsule(const Place &place, const urdf::Link &source, HandLink &link)
{
    const std::string expected =
        "; expected a capsule along +x from the origin: one cylinder and a sphere at either end";
    const urdf::Cylinder *cylinder = nullptr;
    urdf::Pose cylinder_pose;
    std::vector<btVector3> ends;
    std::vector<double> radii;
    for (const auto &collision : source.collision_array) {
        if (const auto *sphere = dynamic_cast<const urdf::Sphere *>(collision->geometry.get())) {
            ends.push_back(vector_of(collision->origin.position));
            radii.push_back(sphere->radius);
        } else if (const auto *found = dynamic_cast<const urdf::Cylinder *>(collision->geometry.get())) {
            cylinder = found;
            cylinder_pose = collision->origin;
        }
    }
    if (source.collision_array.size() != 3 || !cylinder || ends.size() != 2) {
        place.fail("has no <collision> shape of three parts" + expected);
    }
    if (ends[0].x() > ends[1].x()) std::swap(ends[0], ends[1]);
    link.capsule = {cylinder->length, cylinder->radius};
    const btVector3 axis = matrix_of(cylinder_pose.rotation).getColumn(2);
    const bool along_x = near(axis, btVector3(1, 0, 0)) || near(axis, btVector3(-1, 0, 0));
    const bool centred = near(vector_of(cylinder_pose.position), btVector3(cylinder->length / 2, 0, 0));
    const bool ended = near(ends[0], btVector3(0, 0, 0)) && near(ends[1], btVector3(cylinder->length, 0, 0));
    const bool round = std::abs(radii[0] - cylinder->radius) <= frame_tolerance &&
                       std::abs(radii[1] - cylinder->radius) <= frame_tolerance;
    if (!(cylinder->length > 0 && cylinder->radius > 0))
        place.fail("has a <collision> shape without length or radius" + expected);
    if (!along_x || !centred || !ended) place.fail("has <collision> parts that do not meet" + expected);
    if (!round) place.fail("has <collision> parts of different radii" + expected);
}

// The palm's children in the order thumb, index, middle, ring, little; others after, in the parser's order.
std::size_t rank(const urdf::Link &link)
{
    constexpr std::array<std::string_view, 5> fingers = {"thumb", "index", "middle", "ring", "little"};
    const auto found = std::find_if(fingers.begin(), fingers.end(), [&link](std::string_view finger) {
        return link.parent_joint->name.rfind(finger, 0) == 0;
    });
    return static_cast<std::size_t>(found - fingers.begin());
}

// A link that says where the palm frame is, and is no body.
bool is_palm_frame(const urdf::Link &link)
{
    return link.name == "palm" && !link.inertial && link.collision_array.empty();
}

// The rotation of a URDF origin from its angles, not from urdfdom's quaternion: right angles stay right to the last
// bit, which the trajectories of all trials depend on.
btMatrix3x3 matrix_of_angles(const urdf::Rotation &rotation)
{
    constexpr double rounding = 1e-15;
    std::array<double, 3> angle_rad{};
    rotation.getRPY(angle_rad[0], angle_rad[1], angle_rad[2]);
    std::array<double, 3> c{};
    std::array<double, 3> s{};
    for (std::size_t i = 0; i < angle_rad.size(); ++i) {
        c[i] = std::cos(angle_rad[i]);
        s[i] = std::sin(angle_rad[i]);
        if (std::abs(c[i]) < rounding) c[i] = 0;
        if (std::abs(s[i]) < rounding) s[i] = 0;
    }
    const auto [cr, cp, cy] = c;
    const auto [sr, sp, sy] = s;
    return {cy * cp,
            cy * sp * sr - sy * cr,
            cy * sp * cr + sy * sr, // yaw about z, after pitch, after roll
            sy * cp,
            sy * sp * sr + cy * cr,
            sy * sp * cr - cy * sr, //
            -sp,
            cp * sr,
            cp * cr};
}

void read_palm_frame(const std::filesystem::path &path, const urdf::Link &root, HandModel &hand)
{
    const auto found = std::find_if(root.child_links.begin(), root.child_links.end(),
                                    [](const auto &child) { return is_palm_frame(*child); });
    if (found == root.child_links.end())
        Place{path, root.name}.fail("does not carry the palm frame, a link \"palm\" without mass and shape");
    const urdf::Joint &joint = *(*found)->parent_joint;
    if (joint.type != urdf::Joint::FIXED)
        Place{path, (*found)->name}.fail("hangs on joint \"" + joint.name + "\", which is not fixed");
    const auto &origin = joint.parent_to_joint_origin_transform;
    hand.X_hand_palm = btTransform(matrix_of_angles(origin.rotation), vector_of(origin.position));
}

// The first visual shape of the root, if it is a box.
void read_palm_box(const urdf::Link &root, HandModel &hand)
{
    if (!root.visual) return;
    const auto *box = dynamic_cast<const urdf::Box *>(root.visual->geometry.get());
    if (box == nullptr) return;
    hand.X_hand_box = btTransform(matrix_of(root.visual->origin.rotation), vector_of(root.visual->origin.position));
    hand.box_size_m = vector_of(box->dim);
}

// Append the links below `source` to `hand`, parents before children. `parent` is the index of `source`.
void read_children(const std::filesystem::path &path, const urdf::Link &source, int parent, HandModel &hand)
{
    std::vector<urdf::LinkSharedPtr> children = source.child_links;
    std::stable_sort(children.begin(), children.end(),
                     [](const auto &a, const auto &b) { return rank(*a) < rank(*b); });
    for (const auto &child : children) {
        if (parent < 0 && is_palm_frame(*child)) continue;
        const Place place{path, child->name};
        HandLink link;
        link.name = child->name;
        link.parent = parent;
        read_joint(place, *child->parent_joint, link);
        read_inertial(place, *child, link);
        read_capsule(place, *child, link);
        hand.links.push_back(link);
        read_children(path, *child, static_cast<int>(hand.links.size()) - 1, hand);
    }
}

} // namespace

int HandModel::link_of_joint(const std::string &joint) const
{
    const auto found =
        std::find_if(links.begin(), links.end(), [&joint](const HandLink &link) { return link.joint == joint; });
    if (found == links.end()) throw std::out_of_range("hand \"" + name + "\" has no joint \"" + joint + "\"");
    return static_cast<int>(found - links.begin());
}

int HandModel::link_count() const
{
    return static_cast<int>(links.size()) + 1;
}

int HandModel::dof_count() const
{
    return static_cast<int>(
        std::count_if(links.begin(), links.end(), [](const HandLink &link) { return link.revolute; }));
}

HandModel read_hand_model(const std::filesystem::path &path)
{
    const auto model = read_urdf(path);
    HandModel hand;
    hand.name = model->getName();
    hand.root = model->getRoot()->name;
    read_children(path, *model->getRoot(), -1, hand);
    read_palm_frame(path, *model->getRoot(), hand);
    read_palm_box(*model->getRoot(), hand);
    return hand;
}

} // namespace twiddle::sim
