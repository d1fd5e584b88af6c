#include "choices.hpp"
#include "commands.hpp"
#include "engine/export/c_text.hpp"
#include "engine/export/skill_header.hpp"
#include "record/part_file.hpp"
#include "runs/learned_policy.hpp"
#include "runs/run_folder.hpp"
#include "runs/usage_error.hpp"

#include <iostream>

namespace twiddle::cli
{

namespace
{

std::string name_for(const ExportOptions &options, const record::RunSpecification &specification)
{
    const std::string name = options.name.empty() ? engine::skill_name(specification) : options.name;
    if (!engine::is_c_name(name))
        throw runs::UsageError("no names in C can begin with '" + name +
                               "'; name a start of at most 40 letters, digits and single underscores by --name");
    return name;
}

} // namespace

int run_command(const ExportOptions &options, const Arguments & /*arguments*/)
{
    const runs::RunFolder folder{options.run_dir};
    const record::Run run = runs::run_in(folder);
    const record::RunSpecification &specification = run.specification;
    require_supported(specification);
    const std::string name = name_for(options, specification);
    if (!run.complete)
        throw runs::UsageError("the run in '" + folder.path.string() +
                               "' is not complete; finish it by train --resume");

    const std::filesystem::path models = models_dir(options.models_dir);
    const record::Policy policy = runs::learned_policy(folder, specification);
    runs::require_learner(folder, specification, policy);
    const std::string header = engine::skill_header(name, specification, policy, models);
    if (options.out.empty()) {
        std::cout << header;
    } else {
        record::write_file(options.out, header);
        std::cout << "written: " << options.out << '\n';
    }
    return 0;
}

} // namespace twiddle::cli
