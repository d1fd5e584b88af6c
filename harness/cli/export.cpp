#include "commands.hpp"
#include "errors.hpp"
#include "executable.hpp"
#include "experiment/skill_header.hpp"
#include "learned_policy.hpp"
#include "options.hpp"
#include "record/c_text.hpp"
#include "record/part_file.hpp"
#include "run_folder.hpp"

#include <iostream>
#include <memory>

namespace twiddle::cli
{

namespace
{

struct ExportOptions {
    std::string run_dir;
    bool c_header = false;
    std::string name; // empty: of object and model
    std::string out;  // empty: standard output
    std::string models_dir;
};

void write_file(const std::filesystem::path &path, const std::string &text)
{
    record::PartFile file(path);
    file.write(text);
    file.finish();
}

std::string name_for(const ExportOptions &options, const record::RunSpecification &specification)
{
    const std::string name = options.name.empty() ? experiment::skill_name(specification) : options.name;
    if (!record::is_c_name(name))
        throw UsageError("no names in C can begin with '" + name +
                         "'; name a start of at most 40 letters, digits and single underscores by --name");
    return name;
}

int export_run(const ExportOptions &options, const std::vector<std::string> &arguments)
{
    const RunFolder folder{options.run_dir};
    const record::Run run = run_in(folder);
    const record::RunSpecification &specification = run.specification;
    require_supported(specification);
    const std::string name = name_for(options, specification);
    if (!run.complete)
        throw UsageError("the run in '" + folder.path.string() + "' is not complete; finish it by train --resume");
    // The learner's input is then of the run's own number type, to the last bit.
    hand_over(specification.number, arguments);

    const std::filesystem::path models = models_dir(options.models_dir);
    const record::Policy policy = learned_policy(folder, specification);
    require_learner(folder, specification, policy);
    const std::string header = experiment::skill_header(name, specification, policy, models);
    if (options.out.empty()) {
        std::cout << header;
    } else {
        write_file(options.out, header);
        std::cout << "written: " << options.out << '\n';
    }
    return 0;
}

} // namespace

void add_export(CLI::App &app, Session &session)
{
    CLI::App *command = app.add_subcommand("export", "Write what a run has learned for firmware, as a C header");
    const auto options = std::make_shared<ExportOptions>();
    command->add_option("RUN_DIR", options->run_dir, "Folder of a complete run")->required()->type_name("");
    command->add_flag("--c-header", options->c_header, "As constants in C99, for any number build")->required();
    command->add_option("--name", options->name, "What the header's names begin with [OBJECT_MODEL]")
        ->type_name("NAME");
    command->add_option("--out", options->out, "File to write [standard output]")->type_name("FILE");
    add_models_option(*command, options->models_dir);
    command->callback(
        [options, &session] { session.run = [options, &session] { return export_run(*options, session.arguments); }; });
}

} // namespace twiddle::cli
