#include "page_text.hpp"

#include "record/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace twiddle::view
{

namespace
{

bool is_plain(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
           c == '_' || c == '/';
}

} // namespace

std::string html_text(std::string_view text)
{
    std::string escaped;
    for (const char c : text) {
        if (c == '&')
            escaped += "&amp;";
        else if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '"')
            escaped += "&quot;";
        else if (c == '\'')
            escaped += "&#39;";
        else
            escaped += c;
    }
    return escaped;
}

std::string link_text(std::string_view path)
{
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string link = "./";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (is_plain(c))
            link += c;
        else
            link += {'%', digits[byte / 16], digits[byte % 16]};
    }
    return link;
}

std::string script_json(const record::Json &value)
{
    std::string text = value.dump(-1, ' ', false, record::Json::error_handler_t::replace);
    text = record::with_replaced(text, "<", "\\u003c");
    text = record::with_replaced(text, "\u2028", "\\u2028"); // ends a line in some readers of JavaScript
    return record::with_replaced(text, "\u2029", "\\u2029");
}

std::string filled_page(std::string_view page, const std::map<std::string, std::string> &texts)
{
    std::string filled;
    while (!page.empty()) {
        const std::size_t begin = std::min(page.find('@'), page.size());
        filled += page.substr(0, begin);
        page.remove_prefix(begin);
        if (page.empty()) break;
        const std::size_t end = page.find('@', 1);
        const auto text =
            end == std::string_view::npos ? texts.end() : texts.find(std::string(page.substr(1, end - 1)));
        filled += text == texts.end() ? std::string(1, '@') : text->second;
        page.remove_prefix(text == texts.end() ? 1 : end + 1);
    }
    return filled;
}

} // namespace twiddle::view
