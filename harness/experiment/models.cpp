#include "models.hpp"

#include <stdexcept>

namespace twiddle::experiment
{

namespace
{

constexpr std::array<const twd_model *, 4> models = {&twd_model_s, &twd_model_m, &twd_model_c, &twd_model_h};
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
    for (const twd_model *model : models) {
        names.emplace_back(model->name);
    }
    return names;
}

const twd_model &find_model(const std::string &name)
{
    std::string known;
    for (const twd_model *model : models) {
        if (name == model->name) return *model;
        known += known.empty() ? model->name : std::string(", ") + model->name;
    }
    throw std::invalid_argument("unknown model '" + name + "'; the models are " + known);
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
