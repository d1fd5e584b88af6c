// page_text.hpp: text and data on their way into a page, so that nothing of a run can become part of its code.
#pragma once

#include "record/json.hpp"

#include <map>
#include <string>
#include <string_view>

namespace twiddle::view
{

// `text` as HTML text or the value of an attribute in quotes.
std::string html_text(std::string_view text);

// `path` as a relative link, from the folder of the page.
std::string link_text(std::string_view path);

// `value` as JSON within a script element, which no text in it can end; what is no UTF-8 is replaced.
std::string script_json(const record::Json &value);

// `page` with each @NAME@ in it replaced by its text of `texts`, which is taken as it is.
std::string filled_page(std::string_view page, const std::map<std::string, std::string> &texts);

} // namespace twiddle::view
