#include "hand_tables.hpp"

#include "c_text.hpp"
#include "settings/joints.hpp"

#include <stdexcept>

namespace twiddle::engine
{
namespace
{

constexpr int chain_joints = 4;

std::string number(double value)
{
    return c_constant(CType::num, value);
}

std::string row(const btVector3 &values)
{
    return "{" + number(values.x()) + ", " + number(values.y()) + ", " + number(values.z()) + "}";
}

std::string range_line(const sim::HandModel &hand, Joint joint, const char *index)
{
    const sim::HandLink &link = hand.links[hand.link_of_joint(joint_urdf_names[joint])];
    const std::string name = joint_urdf_names[joint];
    return std::string("    [") + index + "] = {" + number(link.lower_rad) + ", " + number(link.upper_rad) + "}, /* " +
           name + " */\n";
}

// Joint `finger`_0 to _3, each on the link of the one before.
std::string chain(const sim::HandModel &hand, const std::string &finger)
{
    std::string text = "static const struct twd_chain_joint " + finger + "_joint[] = {\n";
    int parent = -1;
    for (int joint = 0; joint < chain_joints; ++joint) {
        const int index = hand.link_of_joint(finger + "_" + std::to_string(joint));
        const sim::HandLink &link = hand.links[index];
        if (link.parent != parent)
            throw std::runtime_error("joint \"" + link.joint + "\" does not follow the one before it");
        parent = index;
        const btMatrix3x3 &rotation = link.X_parent_joint.getBasis();
        text += "    /* " + link.joint + " */\n";
        text += "    {.rotation = {" + row(rotation[0]) + ",\n                  " + row(rotation[1]) +
                ",\n                  " + row(rotation[2]) + "},\n";
        text += "     .origin_m = " + row(link.X_parent_joint.getOrigin()) + ",\n";
        text += "     .mass_kg = " + number(link.mass_kg) + ",\n";
        text += "     .centre_of_mass_m = " + row(link.p_link_com_m) + "},\n";
    }
    text += "};\n\nconst struct twd_chain twd_icub_" + finger + " = {.joints = " + std::to_string(chain_joints) +
            ", .joint = " + finger + "_joint};\n";
    return text;
}

} // namespace

std::string hand_tables(const sim::HandModel &hand)
{
    return "/* Written by twiddle-hand-tables from models/" + hand.name +
           ".urdf (`make hand-tables`); change it there. */\n"
           "#include <twiddle/icub_right_hand.h>\n\n"
           "/* clang-format off */\n\n"
           "const struct twd_joint_range twd_icub_joint_range[TWD_ICUB_JOINTS] = {\n" +
           range_line(hand, fei, "TWD_ICUB_FEI") + range_line(hand, aai, "TWD_ICUB_AAI") +
           range_line(hand, fet, "TWD_ICUB_FET") + range_line(hand, ot, "TWD_ICUB_OT") + "};\n\n" +
           chain(hand, "index") + "\n" + chain(hand, "thumb");
}

} // namespace twiddle::engine
