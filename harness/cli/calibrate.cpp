#include "calibration_session.hpp"
#include "commands.hpp"
#include "errors.hpp"
#include "executable.hpp"
#include "options.hpp"
#include "stop_request.hpp"
#include "sweep_folder.hpp"

#include <iostream>
#include <memory>

namespace twiddle::cli
{

namespace
{

struct CalibrateOptions {
    std::string plan;
    std::string out;
    std::string jobs;
    std::string models_dir;
    std::string paper_dir = TWIDDLE_PAPER_DIR;
};

calibration::CalibrationPlan read_plan(const std::string &path, const std::filesystem::path &models)
{
    try {
        return calibration::read_calibration_plan(path, models);
    } catch (const std::runtime_error &error) {
        throw UsageError(error.what()); // the file is the user's choice
    }
}

int calibrate(const CalibrateOptions &options)
{
    const std::size_t jobs = jobs_at_a_time(options.jobs);
    const std::filesystem::path models = models_dir(options.models_dir);
    const RunOptions defaults;
    record::RunSpecification common;
    common.stepper = defaults.stepper;
    common.hand = defaults.hand;
    common.number = own_number();
    calibration::CalibrationPlan plan = read_plan(options.plan, models);
    results::PaperValues paper = results::read_paper_values(options.paper_dir);
    make_folder(options.out);
    catch_stop_signals();
    CalibrationSession session(std::move(plan), std::move(paper), std::move(common), models, options.out, jobs);
    if (session.run()) return 0;
    std::cerr << "twiddle: stopped; the same command goes on\n";
    return 128 + stop_signal(); // as a shell reports it
}

} // namespace

void add_calibrate(CLI::App &app, Session &session)
{
    CLI::App *command = app.add_subcommand(
        "calibrate", "Search a set-up that comes near the paper's tables; writes candidates.csv, setup-1.toml, ...");
    const auto options = std::make_shared<CalibrateOptions>();
    command->add_option("PLAN", options->plan, "A .toml file as those in models/calibrations")->required();
    command->add_option("--out", options->out, "Folder to write to")->required()->type_name("DIR");
    command->add_option("--jobs", options->jobs, "Runs at a time [one a processor]")->type_name("N");
    command->add_option("--paper", options->paper_dir, "Folder of the paper's tables as CSV")->type_name("DIR");
    add_models_option(*command, options->models_dir);
    command->callback([options, &session] { session.run = [options] { return calibrate(*options); }; });
}

} // namespace twiddle::cli
