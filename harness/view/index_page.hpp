// index_page.hpp: a page with all runs of a sweep as a table, each a link to its replay.
#pragma once

#include "sweep_view.hpp"

#include <string>

namespace twiddle::view
{

// The HTML: a row an object and variant, a column a model and seed, each cell coloured by the rotation it says.
std::string index_page(const SweepView &sweep);

} // namespace twiddle::view
