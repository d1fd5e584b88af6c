// library_models.hpp: the learning models as the C library has them.
#pragma once

#include <twiddle/model.h>

#include <array>
#include <string>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

struct LibraryModel {
    const twd_model *model;
    // In C, e.g. "twd_model_h".
    const char *c_name;
};

// In the order of model_names() (models.hpp).
const std::array<LibraryModel, 4> &library_models();

// Throws std::invalid_argument that lists the known names.
const LibraryModel &find_library_model(const std::string &name);
const twd_model &find_model(const std::string &name);

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
