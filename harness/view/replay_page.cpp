#include "replay_page.hpp"

#include "page_text.hpp"
#include "settings/constants.hpp"
#include "templates.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>

namespace twiddle::view
{

namespace
{

using record::Json;

// Whole numbers are the shortest text: positions in 0.01 mm, angles in 0.0001 rad, forces in mN.
constexpr double per_m = 1e5;
constexpr double per_rad = 1e4;
constexpr double per_n = 1e3;

std::int64_t whole(double value, double parts)
{
    return std::llround(value * parts);
}

// For what is sent once.
double rounded(double value)
{
    constexpr double parts = 1e6;
    return std::round(value * parts) / parts + 0.0;
}

Json json_of(const btVector3 &vector)
{
    return {rounded(vector.x()), rounded(vector.y()), rounded(vector.z())};
}

// The three rows of a pose as twelve numbers.
Json json_of(const btTransform &pose)
{
    Json numbers = Json::array();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            numbers.push_back(rounded(pose.getBasis()[row][column]));
        }
        numbers.push_back(rounded(pose.getOrigin()[row]));
    }
    return numbers;
}

Json json_of(const LinkView &link)
{
    return {{"parent", link.parent},
            {"joint", link.joint},
            {"held", rounded(link.held_rad)},
            {"at", json_of(link.X_parent_link)},
            {"length", rounded(link.length_m)},
            {"radius", rounded(link.radius_m)}};
}

Json json_of(const ObjectView &object)
{
    return {{"shape", object.shape},
            {"radius", rounded(object.radius_m)},
            {"height", rounded(object.height_m)},
            {"rounding", rounded(object.rounding_m)},
            {"at", json_of(object.p_palm_centre_m)},
            {"direction", object.counted_direction}};
}

// A row a step: four angles, the rotation, two forces, six coordinates.
Json json_of(const std::vector<StepView> &steps)
{
    Json rows = Json::array();
    for (const StepView &step : steps) {
        Json row = Json::array();
        for (const double angle_rad : step.angle_rad) {
            row.push_back(whole(angle_rad, per_rad));
        }
        row.push_back(whole(step.rotation_rad, per_rad));
        row.push_back(whole(step.index_force_n, per_n));
        row.push_back(whole(step.thumb_force_n, per_n));
        for (const btVector3 &tip_m : {step.p_palm_index_tip_m, step.p_palm_thumb_tip_m}) {
            for (int axis = 0; axis < 3; ++axis) {
                row.push_back(whole(tip_m[axis], per_m));
            }
        }
        rows.push_back(row);
    }
    return rows;
}

Json json_of(const RunView &run)
{
    Json facts = Json::array();
    for (const auto &[name, value] : run.facts) {
        facts.push_back(Json::array({name, value}));
    }
    Json links = Json::array();
    for (const LinkView &link : run.links) {
        links.push_back(json_of(link));
    }
    return {{"title", run.title},
            {"facts", facts},
            {"step_s", control_step_s},
            {"palm", {{"at", json_of(run.X_palm_box)}, {"size", json_of(run.box_size_m)}}},
            {"links", links},
            {"object", json_of(run.object)},
            {"rows", json_of(run.steps)}};
}

} // namespace

std::string replay_page(const std::vector<RunView> &runs)
{
    std::string title;
    Json data = Json::array();
    for (const RunView &run : runs) {
        title += (title.empty() ? "" : " and ") + run.title;
        data.push_back(json_of(run));
    }
    return filled_page(replay_template, {{"TITLE", html_text(title)}, {"DATA", script_json(data)}});
}

} // namespace twiddle::view
