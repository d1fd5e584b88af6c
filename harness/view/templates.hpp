// templates.hpp: the pages as they stand in the files beside this one; page_text.hpp fills them.
#pragma once

namespace twiddle::view
{

extern const char *const replay_html;
extern const char *const index_html;

// The script of replay.html: first what is drawn in space, then the page around it.
extern const char *const scene_js;
extern const char *const replay_js;

} // namespace twiddle::view
