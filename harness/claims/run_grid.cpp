#include "run_grid.hpp"

#include "record/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace twiddle::claims
{

namespace
{

double number_of(const std::string &text)
{
    const std::optional<double> value = record::parse_number(text);
    if (!value) throw std::runtime_error("the paper's tables hold '" + text + "' where a number must be");
    return *value;
}

RunMeasures made_up_run(double rotation_rad)
{
    RunMeasures run;
    run.folder = "the paper";
    run.final_rotation_rad = rotation_rad;
    return run;
}

} // namespace

const Runs *RunGrid::find(const std::string &object, const std::string &model, bool centre) const
{
    const auto found = cells.find({object, model, centre});
    return found == cells.end() ? nullptr : &found->second;
}

RunGrid read_run_grid(const std::filesystem::path &folder, const results::Sweep &sweep,
                      const results::PaperValues &paper)
{
    RunGrid grid;
    std::vector<std::string> others;
    for (const results::SweepRun &run : sweep.runs) {
        if (!run.variant.empty()) continue;
        grid.cells[{run.object, run.model, run.centre}].push_back(read_run_measures(folder, sweep, run));
        if (std::find(others.begin(), others.end(), run.object) == others.end()) others.push_back(run.object);
    }
    for (const std::string &object : paper.objects) {
        const auto found = std::find(others.begin(), others.end(), object);
        if (found == others.end()) continue;
        grid.objects.push_back(object);
        others.erase(found);
    }
    grid.objects.insert(grid.objects.end(), others.begin(), others.end());
    return grid;
}

RunGrid grid_of_table1(const results::PaperValues &paper)
{
    RunGrid grid{paper.objects, {}};
    for (const auto &[key, reward] : paper.reward) {
        grid.cells[{key.first, "cpg-h", key.second}] = {made_up_run(number_of(reward))};
    }
    return grid;
}

RunGrid grid_of_table2(const results::PaperValues &paper)
{
    RunGrid grid{paper.objects, {}};
    for (const auto &[key, cell] : paper.with_centre) {
        const double half = number_of(cell.sd) * std::sqrt(3.0) / 2;
        const double mean = number_of(cell.mean);
        grid.cells[{key.first, key.second, true}] = {made_up_run(mean - half), made_up_run(mean - half),
                                                     made_up_run(mean + half), made_up_run(mean + half)};
    }
    return grid;
}

RunGrid grid_of_best(const results::PaperValues &paper)
{
    RunGrid grid{paper.objects, {}};
    for (const auto &[key, cell] : paper.with_centre) {
        grid.cells[{key.first, key.second, true}] = {made_up_run(number_of(cell.best))};
    }
    return grid;
}

} // namespace twiddle::claims
