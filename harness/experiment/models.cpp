#include "models.hpp"

#include <algorithm>
#include <stdexcept>

namespace twiddle::experiment
{

namespace
{

struct KnownModel {
    const twd_model *model;
    const char *c_name;
};

constexpr std::array<KnownModel, 4> models = {{{&twd_model_s, "twd_model_s"},
                                               {&twd_model_m, "twd_model_m"},
                                               {&twd_model_c, "twd_model_c"},
                                               {&twd_model_h, "twd_model_h"}}};
constexpr std::array<const twd_topology *, expert_count> experts = {&twd_cpg_c, &twd_cpg_m, &twd_cpg_s};

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
    for (const KnownModel &known : models) {
        names.emplace_back(known.model->name);
    }
    return names;
}

const twd_model &find_model(const std::string &name)
{
    std::string names;
    for (const KnownModel &known : models) {
        if (name == known.model->name) return *known.model;
        names += (names.empty() ? "" : ", ") + std::string(known.model->name);
    }
    throw std::invalid_argument("unknown model '" + name + "'; the models are " + names);
}

std::string c_name(const twd_model &model)
{
    const auto known =
        std::find_if(models.begin(), models.end(), [&](const KnownModel &each) { return each.model == &model; });
    if (known == models.end()) throw std::invalid_argument("a model that is none of the list has no name in C");
    return known->c_name;
}

std::vector<std::string> parameter_names(const twd_model &model, bool with_centre)
{
    std::vector<std::string> names;
    for (int k = 0; k < model.cpgs; ++k) {
        append_names(names, *model.topology[k], with_centre);
    }
    for (int k = 0; model.cpgs > 1 && k < model.cpgs; ++k) {
        names.push_back(std::string("selector.") + model.topology[k]->name);
    }
    return names;
}

ExpertWeights expert_weights(const twd_model &model, const twd_num *weight)
{
    ExpertWeights weights{};
    for (int k = 0; k < model.cpgs; ++k) {
        for (std::size_t expert = 0; expert < expert_count; ++expert) {
            if (model.topology[k] == experts[expert]) weights[expert] = shown_num(weight[k]);
        }
    }
    return weights;
}

} // namespace twiddle::experiment
