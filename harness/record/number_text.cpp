#include "number_text.hpp"

#include <array>
#include <charconv>

namespace twiddle::record
{

namespace
{

template <class Number> std::string shortest_text(Number value)
{
    std::array<char, 40> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), result.ptr);
}

template <class Number> std::optional<Number> parse(std::string_view text)
{
    Number value{};
    const char *end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
    return value;
}

} // namespace

std::string number_text(double value)
{
    return shortest_text(value);
}

std::string number_text(double value, std::string_view number)
{
    return number == "float" ? shortest_text(static_cast<float>(value)) : shortest_text(value);
}

std::optional<double> parse_number(std::string_view text)
{
    return parse<double>(text);
}

std::optional<std::uint64_t> parse_whole_number(std::string_view text)
{
    return parse<std::uint64_t>(text);
}

} // namespace twiddle::record
