#include "calibration/calibration_session.hpp"
#include "choices.hpp"
#include "commands.hpp"
#include "runs/stop_request.hpp"
#include "runs/usage_error.hpp"
#include "sweeps/sweep_folder.hpp"

#include <iostream>

namespace twiddle::cli
{

namespace
{

calibration::CalibrationPlan read_plan(const std::string &path, const std::filesystem::path &models)
{
    try {
        return calibration::read_calibration_plan(path, models, setups_dir(models));
    } catch (const std::runtime_error &error) {
        throw runs::UsageError(error.what()); // the file is the user's choice
    }
}

} // namespace

int run_command(const CalibrateOptions &options, const Arguments & /*arguments*/)
{
    require_number(options.number);
    const std::size_t jobs = jobs_at_a_time(options.jobs);
    const std::filesystem::path models = models_dir(options.models_dir);
    const RunOptions defaults;
    record::RunSpecification common;
    common.stepper = defaults.stepper;
    common.hand = defaults.hand;
    common.number = options.number;
    calibration::CalibrationPlan plan = read_plan(options.plan, models);
    results::PaperValues paper = results::read_paper_values(paper_dir(options.paper_dir));
    sweeps::make_folder(options.out);
    runs::catch_stop_signals();
    calibration::CalibrationSession session(std::move(plan), std::move(paper), std::move(common), models, options.out,
                                            jobs);
    if (session.run()) return 0;
    std::cerr << "twiddle: stopped; the same command goes on\n";
    return 128 + runs::stop_signal(); // as a shell reports it
}

} // namespace twiddle::cli
