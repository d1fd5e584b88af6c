#include "library_models.hpp"

#include <stdexcept>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

const std::array<LibraryModel, 4> &library_models()
{
    static const std::array<LibraryModel, 4> models = {{{&twd_model_s, "twd_model_s"},
                                                        {&twd_model_m, "twd_model_m"},
                                                        {&twd_model_c, "twd_model_c"},
                                                        {&twd_model_h, "twd_model_h"}}};
    return models;
}

const LibraryModel &find_library_model(const std::string &name)
{
    std::string names;
    for (const LibraryModel &known : library_models()) {
        if (name == known.model->name) return known;
        names += (names.empty() ? "" : ", ") + std::string(known.model->name);
    }
    throw std::invalid_argument("unknown model '" + name + "'; the models are " + names);
}

const twd_model &find_model(const std::string &name)
{
    return *find_library_model(name).model;
}

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
