// text.hpp: a text with other words in it.
#pragma once

#include <string>
#include <string_view>

namespace twiddle::record
{

// `text` with each `from`, which is not empty, as `to`. What comes in by `to` is not looked at again.
std::string with_replaced(std::string text, std::string_view from, std::string_view to);

} // namespace twiddle::record
