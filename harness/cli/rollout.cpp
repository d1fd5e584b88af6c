#include "commands.hpp"
#include "errors.hpp"
#include "executable.hpp"
#include "experiment/training.hpp"
#include "options.hpp"
#include "record/csv.hpp"
#include "record/number_text.hpp"

#include <iostream>
#include <memory>

namespace twiddle::cli
{

namespace
{

std::string trimmed(const std::string &text)
{
    const std::string blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// One line of standard input as parameters. Throws UsageError that names the line.
experiment::Parameters parse_parameters(const std::string &line, std::size_t line_number, std::size_t count)
{
    const std::string where = "line " + std::to_string(line_number) + " of standard input: ";
    const std::vector<std::string> cells = record::split_csv(line);
    const std::size_t found = trimmed(line).empty() ? 0 : cells.size();
    if (found != count)
        throw UsageError(where + "expected " + std::to_string(count) + " values in (0,1), found " +
                         std::to_string(found));

    experiment::Parameters parameters;
    for (const std::string &cell : cells) {
        const std::optional<double> value = record::parse_number(trimmed(cell));
        if (!value || !(*value > 0) || !(*value < 1))
            throw UsageError(where + "'" + trimmed(cell) + "' is no number in (0,1)");
        parameters.push_back(twd_num_from_double(*value));
    }
    return parameters;
}

int rollout(const RunOptions &options, const std::vector<std::string> &arguments)
{
    require_supported(options);
    if (options.target != "host") throw UsageError("rollout computes on the host; use --target host");
    hand_over(options.number, arguments);

    const std::filesystem::path models = models_dir(options.models_dir);
    const record::RunSpecification specification = run_specification(options, models, 0, 0);
    const twd_model &model = experiment::find_model(specification.model);
    const std::size_t count = twd_model_parameters(&model, specification.centre);
    experiment::TrialRunner runner = experiment::make_trial_runner(specification, models);

    std::string line;
    for (std::size_t line_number = 1; std::getline(std::cin, line); ++line_number) {
        const experiment::TrialResult result = runner.run(parse_parameters(line, line_number, count));
        if (!result.fault.empty()) std::cerr << "twiddle: line " << line_number << ": " << result.fault << '\n';
        std::cout << record::number_text(result.rotation_rad) << std::endl; // at once, for an optimiser that waits
    }
    return 0;
}

} // namespace

void add_rollout(CLI::App &app, Session &session)
{
    CLI::App *command =
        app.add_subcommand("rollout", "Read parameter vectors, one CSV line each; write one rotation in rad a line");
    const auto options = std::make_shared<RunOptions>();
    add_run_options(*command, *options);
    command->callback(
        [options, &session] { session.run = [options, &session] { return rollout(*options, session.arguments); }; });
}

} // namespace twiddle::cli
