#include "index_page.hpp"

#include "page_text.hpp"
#include "results/results_text.hpp"
#include "templates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace twiddle::view
{

namespace
{

// Variant and object; model and whether oscillators have a centre.
using RowName = std::pair<std::string, std::string>;
using ModelName = std::pair<std::string, bool>;

template <class Value> void add_new(std::vector<Value> &values, const Value &value)
{
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

struct Axes {
    std::vector<RowName> rows;
    std::vector<ModelName> models;
    std::vector<std::uint64_t> seeds;
};

Axes axes_of(const SweepView &sweep)
{
    Axes axes;
    for (const IndexCell &cell : sweep.cells) {
        add_new(axes.rows, {cell.run.variant, cell.run.object});
        add_new(axes.models, {cell.run.model, cell.run.centre});
        add_new(axes.seeds, cell.run.seed);
    }
    std::sort(axes.seeds.begin(), axes.seeds.end());
    return axes;
}

double largest_turn_rad(const SweepView &sweep)
{
    double largest_rad = 0;
    for (const IndexCell &cell : sweep.cells) {
        if (cell.rotation_rad) largest_rad = std::max(largest_rad, std::abs(*cell.rotation_rad));
    }
    return largest_rad;
}

// White at 0; towards blue with the counted turn, towards orange against it. The two differ in every common kind of
// colour blindness, and both in lightness from white.
std::string style_of(double share)
{
    const std::array<double, 3> full =
        share < 0 ? std::array<double, 3>{230, 159, 0} : std::array<double, 3>{0, 84, 147};
    const double part = std::min(1.0, std::abs(share));
    std::array<int, 3> colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) {
        colour[i] = static_cast<int>(std::lround(255 + part * (full[i] - 255)));
    }
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "background:#%02x%02x%02x;color:%s", colour[0], colour[1], colour[2],
                  share > 0.75 ? "#fff" : "#000");
    return text.data();
}

std::string cell_html(const IndexCell &cell, double largest_rad)
{
    if (!cell.fault.empty()) return "<td title=\"" + html_text(cell.fault) + "\">fault</td>";
    if (!cell.rotation_rad) return "<td class=\"none\">not complete</td>";
    const std::string number = results::fixed(*cell.rotation_rad, 2);
    const std::string share_style = style_of(largest_rad > 0 ? *cell.rotation_rad / largest_rad : 0);
    std::string title = cell.run.folder;
    if (cell.trained_rad) title += ": mean of the last trials " + results::fixed(*cell.trained_rad, 2) + " rad";
    const std::string text =
        cell.has_page ? "<a href=\"" + html_text(link_text(cell.run.folder + "/replay.html")) + "\">" + number + "</a>"
                      : number;
    return "<td style=\"" + share_style + "\" title=\"" + html_text(title) + "\">" + text + "</td>";
}

// Two header rows: models, and the seeds of each.
std::string header_html(const Axes &axes)
{
    std::string models = "<tr><th rowspan=\"2\" scope=\"col\">object</th>";
    std::string seeds = "<tr>";
    for (const auto &[model, centre] : axes.models) {
        models += "<th scope=\"colgroup\" colspan=\"" + std::to_string(axes.seeds.size()) + "\">" +
                  html_text(results::model_text(model, centre)) + "</th>";
        for (const std::uint64_t seed : axes.seeds) {
            seeds += "<th scope=\"col\">seed " + std::to_string(seed) + "</th>";
        }
    }
    return models + "</tr>\n" + seeds + "</tr>\n";
}

std::string row_html(const SweepView &sweep, const Axes &axes, const RowName &row, double largest_rad)
{
    const auto &[variant, object] = row;
    std::string html =
        "<tr><th scope=\"row\">" + html_text(variant.empty() ? object : variant + ": " + object) + "</th>";
    for (const ModelName &model : axes.models) {
        for (const std::uint64_t seed : axes.seeds) {
            const auto cell = std::find_if(sweep.cells.begin(), sweep.cells.end(), [&](const IndexCell &known) {
                const results::SweepRun &run = known.run;
                return RowName(run.variant, run.object) == row && ModelName(run.model, run.centre) == model &&
                       run.seed == seed;
            });
            html += cell == sweep.cells.end() ? "<td class=\"none\"></td>" : cell_html(*cell, largest_rad);
        }
    }
    return html + "</tr>\n";
}

} // namespace

std::string index_page(const SweepView &sweep)
{
    const Axes axes = axes_of(sweep);
    const double largest_rad = largest_turn_rad(sweep);
    std::string table = "<thead>\n" + header_html(axes) + "</thead>\n<tbody>\n";
    for (const RowName &row : axes.rows) {
        table += row_html(sweep, axes, row, largest_rad);
    }
    const std::size_t pages = static_cast<std::size_t>(
        std::count_if(sweep.cells.begin(), sweep.cells.end(), [](const IndexCell &cell) { return cell.has_page; }));
    return filled_page(index_html, {{"TITLE", html_text(sweep.name)},
                                    {"COUNT", std::to_string(pages) + " of " + std::to_string(sweep.cells.size())},
                                    {"MOST", results::fixed(largest_rad, 2)},
                                    {"VERSION", html_text(sweep.version)},
                                    {"TABLE", table + "</tbody>\n"}});
}

} // namespace twiddle::view
