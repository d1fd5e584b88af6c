// replay_page.hpp: a page of its own that replays runs in a browser.
#pragma once

#include "run_view.hpp"

#include <string>
#include <vector>

namespace twiddle::view
{

// The HTML of one run, or of two side by side. It asks for nothing from anywhere.
std::string replay_page(const std::vector<RunView> &runs);

} // namespace twiddle::view
