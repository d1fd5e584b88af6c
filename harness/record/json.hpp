// json.hpp: the JSON value of our files, by name alone; json_file.hpp has all of it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace twiddle::record
{

// Objects keep the order in which they were filled: files read from top to bottom as they were meant.
using Json = nlohmann::ordered_json;

} // namespace twiddle::record
