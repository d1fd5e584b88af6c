#include "commands.hpp"
#include "executable.hpp"
#include "experiment/models.hpp"
#include "options.hpp"
#include "record/versions.hpp"
#include "sim/object.hpp"
#include "sim/setup.hpp"

#include <iostream>
#include <memory>

namespace twiddle::cli
{

namespace
{

int info(const std::string &models_option)
{
    const std::filesystem::path models = models_dir(models_option);
    std::cout << record::version_line() << '\n'
              << "number type: " << own_number() << '\n'
              << "Bullet: " << record::bullet_version() << '\n'
              << "compiler: " << record::compiler() << '\n'
              << "models folder: " << models.string() << '\n'
              << "objects: " << comma_list(sim::object_names(models)) << '\n'
              << "set-ups: " << comma_list(sim::setup_names(models)) << '\n'
              << "models, parameters with and without centre:\n";
    for (const std::string &name : experiment::model_names()) {
        const twd_model &model = experiment::find_model(name);
        std::cout << "  " << name << ": " << twd_model_parameters(&model, true) << ", "
                  << twd_model_parameters(&model, false) << '\n';
    }
    return 0;
}

} // namespace

void add_info(CLI::App &app, Session &session)
{
    CLI::App *command = app.add_subcommand("info", "Print versions, number type, models, objects and set-ups");
    const auto models = std::make_shared<std::string>();
    add_models_option(*command, *models);
    command->callback([models, &session] { session.run = [models] { return info(*models); }; });
}

} // namespace twiddle::cli
