#include "choices.hpp"
#include "commands.hpp"
#include "engine/engine.hpp"
#include "engine/models.hpp"
#include "record/versions.hpp"
#include "settings/setup.hpp"
#include "sim/object.hpp"

#include <iostream>

namespace twiddle::cli
{

int run_command(const InfoOptions &options, const Arguments & /*arguments*/)
{
    const std::filesystem::path models = models_dir(options.models_dir);
    std::cout << record::version_line() << '\n'
              << "number type: " << engine::number_names().front() << '\n'
              << "Bullet: " << record::bullet_version() << '\n'
              << "compiler: " << record::compiler() << '\n'
              << "models folder: " << models.string() << '\n'
              << "objects: " << comma_list(sim::object_names(models)) << '\n'
              << "set-ups: " << comma_list(settings::setup_names(setups_dir(models))) << '\n'
              << "models, parameters with and without centre:\n";
    for (const std::string &name : engine::model_names()) {
        std::cout << "  " << name << ": " << engine::parameter_count(name, true) << ", "
                  << engine::parameter_count(name, false) << '\n';
    }
    return 0;
}

} // namespace twiddle::cli
