#include "choices.hpp"
#include "commands.hpp"
#include "engine/models.hpp"
#include "experiment/training.hpp"
#include "record/csv.hpp"
#include "record/number_text.hpp"
#include "runs/usage_error.hpp"

#include <iostream>

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
engine::Parameters parse_parameters(const std::string &line, std::size_t line_number, std::size_t count)
{
    const std::string where = "line " + std::to_string(line_number) + " of standard input: ";
    const std::vector<std::string> cells = record::split_csv(line);
    const std::size_t found = trimmed(line).empty() ? 0 : cells.size();
    if (found != count)
        throw runs::UsageError(where + "expected " + std::to_string(count) + " values in (0,1), found " +
                               std::to_string(found));

    engine::Parameters parameters;
    for (const std::string &cell : cells) {
        const std::optional<double> value = record::parse_number(trimmed(cell));
        if (!value || !(*value > 0) || !(*value < 1))
            throw runs::UsageError(where + "'" + trimmed(cell) + "' is no number in (0,1)");
        parameters.push_back(*value);
    }
    return parameters;
}

} // namespace

int run_command(const RolloutOptions &options, const Arguments & /*arguments*/)
{
    require_supported(options.run);
    if (options.run.target != "host") throw runs::UsageError("rollout computes on the host; use --target host");

    const std::filesystem::path models = models_dir(options.run.models_dir);
    const record::RunSpecification specification = run_specification(options.run, models, 0, 0);
    const std::size_t count = engine::parameter_count(specification.model, specification.centre);
    experiment::TrialRunner runner = experiment::make_trial_runner(specification, models);

    std::string line;
    for (std::size_t line_number = 1; std::getline(std::cin, line); ++line_number) {
        const experiment::TrialResult result = runner.run(parse_parameters(line, line_number, count));
        if (!result.fault.empty()) std::cerr << "twiddle: line " << line_number << ": " << result.fault << '\n';
        std::cout << record::number_text(result.rotation_rad) << std::endl; // at once, for an optimiser that waits
    }
    return 0;
}

} // namespace twiddle::cli
