// urdf_file.hpp: URDF files, parsed by urdfdom, with its complaints as exceptions.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <filesystem>

namespace twiddle::sim
{

// Parse `path`. Throws std::runtime_error with one sentence that names the file; prints nothing. The model has a root
// and is a tree: every other link hangs on one joint.
urdf::ModelInterfaceSharedPtr read_urdf(const std::filesystem::path &path);

} // namespace twiddle::sim
