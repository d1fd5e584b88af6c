// c_text.hpp: pieces of C source for the C library: numbers, lists, names, comments.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace twiddle::engine
{

// The library's number types (twiddle/number.h).
enum class CType { num, wide, rate, small };

// `value`, which is finite, as a constant of `type`: TWD_NUM(2) if it is whole, else with the word of the fixed build,
// such as TWD_NUM_CONSTANT(0.1, 26843546). The decimal is the shortest that reads back as `value`. Where the fixed
// build's format does not reach `value`, the word is the format's end.
std::string c_constant(CType type, double value);

// Whether the fixed build's format reaches `value`.
bool fixed_build_reaches(CType type, double value);

// `items` with commas, in lines of at most 120 columns that each begin with `indent` and end with a newline.
std::string c_list(const std::vector<std::string> &items, const std::string &indent);

// `text` for the inside of a comment: on one line, with neither end nor start of a comment in it.
std::string c_comment_text(std::string text);

// `layout` with each @FIELD@ replaced by that of `fields`. Throws std::logic_error for a field that is not among them.
std::string fill(const std::string &layout, const std::map<std::string, std::string> &fields);

// Whether `text` with `_` and more after it is a name in C and in C++: letters, digits and single underscores, a letter
// first and no underscore last; 40 characters at most.
bool is_c_name(const std::string &text);

} // namespace twiddle::engine
