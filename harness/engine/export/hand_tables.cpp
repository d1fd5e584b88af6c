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

// Three numbers in braces behind `before` and ahead of `after`; one a line where a line has no room for them.
std::string row(const std::string &before, const btVector3 &values, const std::string &after)
{
    constexpr std::size_t columns = 120;
    const std::string x = number(values.x()), y = number(values.y()), z = number(values.z());
    const std::string line = before + "{" + x + ", " + y + ", " + z + "}" + after;
    if (line.size() <= columns) return line + "\n";
    const std::string next = ",\n" + std::string(before.size() + 1, ' ');
    return before + "{" + x + next + y + next + z + "}" + after + "\n";
}

std::string range_line(const sim::HandModel &hand, Joint joint, const char *index)
{
    const sim::HandLink &link = hand.links[hand.link_of_joint(joint_urdf_names[joint])];
    const std::string name = joint_urdf_names[joint];
    return "    /* " + name + " */\n    [" + index + "] = {" + number(link.lower_rad) + ", " + number(link.upper_rad) +
           "},\n";
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
        text += row("    {.rotation = {", rotation[0], ",") + row("                  ", rotation[1], ",") +
                row("                  ", rotation[2], "},");
        text += row("     .origin_m = ", link.X_parent_joint.getOrigin(), ",");
        text += "     .mass_kg = " + number(link.mass_kg) + ",\n";
        text += row("     .centre_of_mass_m = ", link.p_link_com_m, "},");
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
