#include "run_view.hpp"

#include "record/csv_columns.hpp"
#include "record/number_text.hpp"
#include "results/results_text.hpp"
#include "runs/learned_policy.hpp"
#include "runs/usage_error.hpp"
#include "settings/constants.hpp"
#include "sim/hand_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace twiddle::view
{

namespace
{

namespace fs = std::filesystem;

// How far a fingertip may be from where angles and URDF place it: what is rounded and no more.
constexpr double tip_tolerance_m = 5e-5;

// The head of a trajectory.
class Head
{
  public:
    explicit Head(const fs::path &path) : path_(path), facts_(record::read_csv_facts(path))
    {
    }

    std::string text(const std::string &name) const
    {
        const auto found = facts_.find(name);
        if (found == facts_.end())
            throw std::runtime_error("'" + path_.string() + "' has no line '# " + name +
                                     ": ...'; twiddle replay writes it again");
        return found->second;
    }

    double number(const std::string &name) const
    {
        const std::optional<double> value = record::parse_number(text(name));
        if (!value || !std::isfinite(*value))
            throw std::runtime_error("'" + path_.string() + "': '" + name + "' must be a number");
        return *value;
    }

  private:
    fs::path path_;
    std::map<std::string, std::string> facts_;
};

ObjectView object_view(const Head &head, const fs::path &path)
{
    ObjectView object;
    object.name = head.text("object");
    object.shape = head.text("object_shape");
    if (object.shape != "sphere" && object.shape != "cylinder" && object.shape != "cube")
        throw std::runtime_error("'" + path.string() + "': 'object_shape' must be sphere, cylinder or cube");
    object.radius_m = head.number("object_size_m");
    object.height_m = head.number("object_height_m");
    object.rounding_m = head.number("object_rounding_m");
    object.p_palm_centre_m.setValue(head.number("object_hinge_x_m"), head.number("object_hinge_y_m"),
                                    head.number("object_centre_z_m"));
    const double direction = head.number("counted_direction");
    if (direction != 1 && direction != -1)
        throw std::runtime_error("'" + path.string() + "': 'counted_direction' must be 1 or -1");
    object.counted_direction = static_cast<int>(direction);
    return object;
}

// The setting that says at which angle the joint named `joint` is held, unless the controller moves it.
std::string holding_setting(const std::string &joint)
{
    if (joint.rfind("index", 0) == 0) return "index_distal_deg";
    if (joint.rfind("thumb", 0) == 0) return "thumb_distal_deg";
    return "other_fingers_deg";
}

int controlled_joint(const std::string &joint)
{
    const auto found = std::find(joint_urdf_names.begin(), joint_urdf_names.end(), joint);
    return found == joint_urdf_names.end() ? -1 : static_cast<int>(found - joint_urdf_names.begin());
}

double held_angle(const sim::HandLink &link, const Head &head, const fs::path &path)
{
    const std::string setting = holding_setting(link.joint);
    const double angle_rad = head.number(setting) * rad_per_deg;
    if (angle_rad < link.lower_rad || angle_rad > link.upper_rad)
        throw std::runtime_error("'" + path.string() + "' is of another hand: " + setting + " is " +
                                 head.text(setting) + ", which joint \"" + link.joint + "\" cannot reach");
    return angle_rad;
}

std::vector<LinkView> link_views(const sim::HandModel &hand, const Head &head, const fs::path &path)
{
    const btTransform X_palm_hand = hand.X_hand_palm.inverse();
    std::vector<LinkView> links;
    for (const sim::HandLink &link : hand.links) {
        LinkView view;
        view.parent = link.parent;
        view.joint = controlled_joint(link.joint);
        if (view.joint < 0 && link.revolute) view.held_rad = held_angle(link, head, path);
        view.X_parent_link = link.parent < 0 ? X_palm_hand * link.X_parent_joint : link.X_parent_joint;
        view.length_m = link.capsule.length_m;
        view.radius_m = link.capsule.radius_m;
        links.push_back(view);
    }
    return links;
}

std::vector<StepView> read_steps(const fs::path &path)
{
    std::vector<std::string> names = {"step"};
    for (const std::string joint : joint_names) {
        names.push_back("actual_" + joint + "_rad");
    }
    names.insert(names.end(), {"index_x_m", "index_y_m", "index_z_m", "thumb_x_m", "thumb_y_m", "thumb_z_m",
                               "object_rad", "index_contact_n", "thumb_contact_n"});
    const std::vector<std::vector<double>> columns = record::read_csv_columns(path, names);
    std::vector<StepView> steps(columns[0].size());
    if (steps.empty()) throw std::runtime_error("'" + path.string() + "' has no row");
    for (std::size_t i = 0; i < steps.size(); ++i) {
        std::size_t column = 0;
        const auto next = [&] { return columns[column++][i]; };
        if (next() != static_cast<double>(i + 1))
            throw std::runtime_error("'" + path.string() + "': row " + std::to_string(i + 1) + " is of another step");
        for (double &angle_rad : steps[i].angle_rad) {
            angle_rad = next();
        }
        for (btVector3 *tip_m : {&steps[i].p_palm_index_tip_m, &steps[i].p_palm_thumb_tip_m}) {
            const double x_m = next();
            const double y_m = next();
            tip_m->setValue(x_m, y_m, next());
        }
        steps[i].rotation_rad = next() + 0.0; // a sum with 0 is never -0
        steps[i].index_force_n = next();
        steps[i].thumb_force_n = next();
    }
    return steps;
}

// The centre of the last end sphere of the finger that ends in link `last`.
btVector3 p_palm_tip_m(const std::vector<LinkView> &links, std::size_t last, const JointVector &angle_rad)
{
    btVector3 point_m(links[last].length_m, 0, 0);
    for (int at = static_cast<int>(last); at >= 0; at = links[static_cast<std::size_t>(at)].parent) {
        const LinkView &link = links[static_cast<std::size_t>(at)];
        const double turned_rad = link.joint < 0 ? link.held_rad : angle_rad[static_cast<std::size_t>(link.joint)];
        point_m = link.X_parent_link * btTransform(btQuaternion(btVector3(0, 0, 1), turned_rad)) * point_m;
    }
    return point_m;
}

// The last link of the finger that carries the controlled joint `joint`.
std::size_t last_link(const sim::HandModel &hand, Joint joint)
{
    int link = hand.link_of_joint(joint_urdf_names[joint]);
    for (int i = link + 1; i < static_cast<int>(hand.links.size()); ++i) {
        if (hand.links[static_cast<std::size_t>(i)].parent == link) link = i;
    }
    return static_cast<std::size_t>(link);
}

void require_tips(const RunView &run, const sim::HandModel &hand, const fs::path &path)
{
    const std::size_t index = last_link(hand, fei);
    const std::size_t thumb = last_link(hand, fet);
    for (std::size_t i = 0; i < run.steps.size(); ++i) {
        const StepView &step = run.steps[i];
        const double off_m =
            std::max((p_palm_tip_m(run.links, index, step.angle_rad) - step.p_palm_index_tip_m).length(),
                     (p_palm_tip_m(run.links, thumb, step.angle_rad) - step.p_palm_thumb_tip_m).length());
        if (!(off_m <= tip_tolerance_m))
            throw std::runtime_error("'" + path.string() + "' is of another hand: in step " + std::to_string(i + 1) +
                                     " a fingertip is " + record::number_text(std::round(off_m * 1e5) / 100) +
                                     " mm from where the URDF places it");
    }
}

// What decides the run's numbers, and not the command: wherever a run was done, its page has the same bytes.
void describe(const record::RunSpecification &what, RunView &view)
{
    view.title =
        what.object + ", " + results::model_text(what.model, what.centre) + ", seed " + std::to_string(what.seed);
    view.facts = {{"object", view.object.name}, {"trials", std::to_string(what.trials)},
                  {"set-up", what.setup},       {"stepper", what.stepper},
                  {"hand", what.hand},          {"number type", what.number}};
}

} // namespace

RunView read_run_view(const runs::RunFolder &folder, const fs::path &models)
{
    const record::Run run = runs::run_in(folder);
    const fs::path path = folder.trajectory_csv();
    if (!fs::exists(path))
        throw runs::UsageError("'" + folder.path.string() +
                               "' holds no trajectory.csv; twiddle replay writes it for a complete run");
    const sim::HandModel hand = sim::read_hand_model(models / "icub_right_hand.urdf");
    const Head head(path);
    RunView view;
    view.object = object_view(head, path);
    view.X_palm_box = hand.X_hand_palm.inverse() * hand.X_hand_box;
    view.box_size_m = hand.box_size_m;
    view.links = link_views(hand, head, path);
    view.steps = read_steps(path);
    // Motors hold the full hand's other joints, and give way.
    if (run.specification.hand == "welded") require_tips(view, hand, path);
    describe(run.specification, view);
    return view;
}

} // namespace twiddle::view
