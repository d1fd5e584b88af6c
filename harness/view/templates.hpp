// templates.hpp: the pages as they stand in replay.html and index.html; page_text.hpp fills them.
#pragma once

namespace twiddle::view
{

extern const char *const replay_template;
extern const char *const index_template;

} // namespace twiddle::view
