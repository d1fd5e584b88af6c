#include "c_text.hpp"

#include "record/number_text.hpp"
#include "record/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace twiddle::engine
{

namespace
{

constexpr std::size_t line_columns = 120;
constexpr std::size_t longest_name =
    40; // with what is appended to it, well within the 63 characters that C99 tells apart

// A format's macros, and how many units of the fixed build a 1 has.
struct Format {
    const char *whole;
    const char *with_word;
    double one;
};

const Format &format_of(CType type)
{
    static const std::array<Format, 4> formats = {{{"TWD_NUM", "TWD_NUM_CONSTANT", 0x1p28},
                                                   {"TWD_WIDE", "TWD_WIDE_CONSTANT", 0x1p24},
                                                   {"TWD_RATE", "TWD_RATE_CONSTANT", 0x1p20},
                                                   {"TWD_SMALL", "TWD_SMALL_CONSTANT", 0x1p34}}};
    return formats.at(static_cast<std::size_t>(type));
}

// Rounded as twiddle/convert.h rounds.
std::int32_t fixed_word(double scaled)
{
    constexpr std::int32_t end = std::numeric_limits<std::int32_t>::max();
    if (scaled >= end) return end;
    if (scaled <= -end) return -end;
    return static_cast<std::int32_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
}

bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

} // namespace

bool fixed_build_reaches(CType type, double value)
{
    return std::abs(value * format_of(type).one) < std::numeric_limits<std::int32_t>::max();
}

std::string c_constant(CType type, double value)
{
    const Format &format = format_of(type);
    const std::string decimal = record::number_text(value);
    if (value == std::trunc(value) && fixed_build_reaches(type, value)) return format.whole + ("(" + decimal + ")");
    return format.with_word + ("(" + decimal + ", ") + std::to_string(fixed_word(value * format.one)) + ")";
}

std::string c_list(const std::vector<std::string> &items, const std::string &indent)
{
    std::string text;
    std::string line = indent;
    for (const std::string &item : items) {
        const std::string space = line == indent ? "" : " ";
        if (!space.empty() && line.size() + space.size() + item.size() + 1 > line_columns) {
            text += line + "\n";
            line = indent + item + ",";
        } else {
            line += space + item + ",";
        }
    }
    return line == indent ? text : text + line + "\n";
}

std::string c_comment_text(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return record::with_replaced(record::with_replaced(text, "*/", "* /"), "/*", "/ *");
}

std::string fill(const std::string &layout, const std::map<std::string, std::string> &fields)
{
    std::string text;
    std::size_t done = 0;
    for (std::size_t at = layout.find('@'); at != std::string::npos; at = layout.find('@', done)) {
        const std::size_t end = layout.find('@', at + 1);
        const auto field = fields.find(layout.substr(at + 1, end - at - 1));
        if (end == std::string::npos || field == fields.end())
            throw std::logic_error("a layout has a field that nothing fills: " + layout.substr(at, end - at));
        text += layout.substr(done, at - done) + field->second;
        done = end + 1;
    }
    return text + layout.substr(done);
}

bool is_c_name(const std::string &text)
{
    if (text.empty() || text.size() > longest_name || !is_letter(text.front()) || text.back() == '_') return false;
    if (text.find("__") != std::string::npos) return false;
    return std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

} // namespace twiddle::engine
