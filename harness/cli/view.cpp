#include "choices.hpp"
#include "commands.hpp"
#include "record/part_file.hpp"
#include "runs/usage_error.hpp"
#include "view/index_page.hpp"
#include "view/replay_page.hpp"
#include "view/run_view.hpp"
#include "view/sweep_view.hpp"

#include <iostream>
#include <system_error>
#include <utility>

namespace twiddle::cli
{

namespace
{

namespace fs = std::filesystem;

// A file, and what is to stand in it.
using Page = std::pair<fs::path, std::string>;

// A page that could not be written whole can be made again; nothing of it stays.
void write_page(const Page &page)
{
    try {
        record::write_file(page.first, page.second);
    } catch (...) {
        std::error_code ignored;
        fs::remove(record::part_path(page.first), ignored);
        throw;
    }
}

void view_run(const ViewOptions &options, const fs::path &models)
{
    if (options.index_only)
        throw runs::UsageError("'" + options.dir + "' is no folder of a sweep; leave out --index-only");
    const runs::RunFolder folder{options.dir};
    std::vector<view::RunView> shown = {view::read_run_view(folder, models)};
    if (!options.compare.empty()) shown.push_back(view::read_run_view({options.compare}, models));
    const fs::path path = options.out.empty() ? folder.replay_html() : fs::path(options.out);
    write_page({path, view::replay_page(shown)});
    std::cout << path.string() << '\n';
}

// Nothing is written before all is read: a page that cannot be made leaves the folder as it was.
void view_sweep(const ViewOptions &options, const fs::path &models)
{
    if (!options.out.empty() || !options.compare.empty())
        throw runs::UsageError("'" + options.dir + "' is the folder of a sweep; --out and --compare are for a run's");
    const fs::path folder = options.dir;
    const view::SweepView sweep = view::read_sweep_view(folder);
    std::vector<Page> pages;
    for (const view::IndexCell &cell : sweep.cells) {
        if (options.index_only || !cell.has_page) continue;
        const runs::RunFolder run{folder / cell.run.folder};
        pages.emplace_back(run.replay_html(), view::replay_page({view::read_run_view(run, models)}));
    }
    pages.emplace_back(folder / "index.html", view::index_page(sweep));
    for (const Page &page : pages) {
        write_page(page);
    }
    std::cout << pages.back().first.string() << '\n';
}

} // namespace

int run_command(const ViewOptions &options, const Arguments & /*arguments*/)
{
    const fs::path models = models_dir(options.models_dir);
    if (fs::exists(fs::path(options.dir) / "sweep.json"))
        view_sweep(options, models);
    else
        view_run(options, models);
    return 0;
}

} // namespace twiddle::cli
