// Compiled once: the models are the same in every build of the library.
#include "models.hpp"

#include "library_models.hpp"

#include <twiddle/input_map.h>

namespace twiddle::engine
{

namespace
{

using namespace TWD_BUILD_NAMESPACE;

void append_names(std::vector<std::string> &names, const twd_topology &cpg, bool with_centre)
{
    const std::string prefix = std::string(cpg.name) + ".";
    if (cpg.chooses_frequency) names.push_back(prefix + "frequency");
    for (int i = 1; i <= cpg.oscillators; ++i) {
        names.push_back(prefix + "amplitude-" + std::to_string(i));
    }
    for (int i = 1; with_centre && i <= cpg.oscillators; ++i) {
        names.push_back(prefix + "centre-" + std::to_string(i));
    }
    for (int i = 0; i < cpg.couplings; ++i) {
        const twd_coupling &coupling = cpg.coupling[i];
        names.push_back(prefix + "phase-lag-" + std::to_string(coupling.first + 1) + "-" +
                        std::to_string(coupling.second + 1));
    }
}

} // namespace

std::vector<std::string> model_names()
{
    std::vector<std::string> names;
    for (const LibraryModel &known : library_models()) {
        names.emplace_back(known.model->name);
    }
    return names;
}

std::vector<std::string> parameter_names(const std::string &model, bool with_centre)
{
    const twd_model &known = find_model(model);
    std::vector<std::string> names;
    for (int k = 0; k < known.cpgs; ++k) {
        append_names(names, *known.topology[k], with_centre);
    }
    for (int k = 0; known.cpgs > 1 && k < known.cpgs; ++k) {
        names.push_back(std::string("selector.") + known.topology[k]->name);
    }
    return names;
}

std::size_t parameter_count(const std::string &model, bool with_centre)
{
    return twd_model_parameters(&find_model(model), with_centre);
}

std::size_t input_count()
{
    return TWD_INPUTS;
}

} // namespace twiddle::engine
