#include "sweep_tables.hpp"

#include "mann_whitney.hpp"

#include <algorithm>
#include <array>

namespace twiddle::results
{

namespace
{

// In the order of the paper's Table 2.
constexpr std::array<const char *, 4> models = {"cpg-s", "cpg-m", "cpg-c", "cpg-h"};

// The one that the paper's Table 1 is about comes first there.
constexpr std::array<const char *, 4> models_of_centre_table = {"cpg-h", "cpg-s", "cpg-m", "cpg-c"};

void add_new(std::vector<std::string> &names, const std::string &name)
{
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// The cells of one variant and object.
struct Group {
    std::string object;
    std::vector<const Cell *> cells;
};

// By variant in the sweep's order, and by object in the paper's order, others after.
std::vector<Group> groups_of(const std::vector<Cell> &cells, const PaperValues &paper)
{
    std::vector<std::string> variants;
    std::vector<std::string> objects = paper.objects;
    for (const Cell &cell : cells) {
        add_new(variants, cell.variant);
        add_new(objects, cell.object);
    }
    std::vector<Group> groups;
    for (const std::string &variant : variants) {
        for (const std::string &object : objects) {
            Group group{object, {}};
            for (const Cell &cell : cells) {
                if (cell.variant == variant && cell.object == object) group.cells.push_back(&cell);
            }
            if (!group.cells.empty()) groups.push_back(group);
        }
    }
    return groups;
}

const Cell *find_cell(const Group &group, const std::string &model, bool centre)
{
    const auto found = std::find_if(group.cells.begin(), group.cells.end(),
                                    [&](const Cell *cell) { return cell->model == model && cell->centre == centre; });
    return found == group.cells.end() ? nullptr : *found;
}

template <class Map, class Key> typename Map::mapped_type value_or_empty(const Map &map, const Key &key)
{
    const auto found = map.find(key);
    return found == map.end() ? typename Map::mapped_type{} : found->second;
}

CentreRow centre_row(const Cell &cell, const PaperValues &paper)
{
    CentreRow row{summary_of(cell), std::nullopt, ""};
    if (cell.model == models_of_centre_table.front())
        row.paper_reward = value_or_empty(paper.reward, std::pair(cell.object, cell.centre));
    return row;
}

void compare_with_winner(std::vector<ModelRow> &rows, const std::vector<const Cell *> &cells)
{
    if (cells.size() < 2) return;
    const auto winner = static_cast<std::size_t>(
        std::max_element(rows.begin(), rows.end(),
                         [](const ModelRow &a, const ModelRow &b) { return a.cell.mean_rad < b.cell.mean_rad; }) -
        rows.begin());
    rows[winner].winner = true;

    std::vector<double> p;
    double smallest_p = 1;
    for (const Cell *cell : cells) {
        if (cell == cells[winner]) continue;
        p.push_back(mann_whitney(cell->rotation_rad, cells[winner]->rotation_rad).p);
        smallest_p = std::min(smallest_p,
                              smallest_mann_whitney_p(cell->rotation_rad.size(), cells[winner]->rotation_rad.size()));
    }
    const double smallest_p_holm = std::min(1.0, static_cast<double>(p.size()) * smallest_p);
    const std::vector<double> p_holm = holm_corrected(p);
    for (std::size_t row = 0, next = 0; row < rows.size(); ++row) {
        if (row == winner) continue;
        rows[row].comparison = {p[next], p_holm[next], smallest_p_holm};
        ++next;
    }
}

} // namespace

CellSummary summary_of(const Cell &cell)
{
    const std::vector<double> &values = cell.rotation_rad;
    CellSummary summary{cell.variant,  cell.object,  cell.model,   cell.centre,
                        values.size(), mean(values), std::nullopt, *std::max_element(values.begin(), values.end()),
                        std::nullopt};
    if (values.size() > 1) {
        summary.sd_rad = standard_deviation(values);
        summary.interval_rad = bootstrap_interval_of_mean(values);
    }
    return summary;
}

std::vector<CentreRow> centre_table(const std::vector<Cell> &cells, const PaperValues &paper)
{
    std::vector<CentreRow> rows;
    for (const Group &group : groups_of(cells, paper)) {
        for (const std::string model : models_of_centre_table) {
            const Cell *with = find_cell(group, model, true);
            const Cell *without = find_cell(group, model, false);
            if (!without && model != models_of_centre_table.front()) continue;
            if (with) rows.push_back(centre_row(*with, paper));
            if (without) rows.push_back(centre_row(*without, paper));
            if (with && without) rows.back().p = mann_whitney(with->rotation_rad, without->rotation_rad).p;
        }
    }
    return rows;
}

std::vector<ModelRow> model_table(const std::vector<Cell> &cells, const PaperValues &paper)
{
    std::vector<ModelRow> table;
    for (const Group &group : groups_of(cells, paper)) {
        std::vector<ModelRow> rows;
        std::vector<const Cell *> compared;
        for (const std::string model : models) {
            const Cell *cell = find_cell(group, model, true);
            if (!cell) continue;
            compared.push_back(cell);
            rows.push_back({summary_of(*cell), false, std::nullopt,
                            value_or_empty(paper.with_centre, std::pair(group.object, model))});
        }
        compare_with_winner(rows, compared);
        table.insert(table.end(), rows.begin(), rows.end());
    }
    return table;
}

} // namespace twiddle::results
