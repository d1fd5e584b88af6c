// number_text.hpp: numbers as text and back, without loss and without locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace twiddle::record
{

// The shortest decimal text that reads back as the same value; "nan" and "inf" for what is no number.
std::string number_text(double value);

// The same for a value that the C library holds in its number type `number`: "float", "double" or "fixed".
std::string number_text(double value, std::string_view number);

// The number that all of `text` spells, as decimal or scientific notation; nothing if it spells none.
std::optional<double> parse_number(std::string_view text);

// The whole number >= 0 that all of `text` spells in decimal digits; nothing if it spells none or one beyond 64 bits.
std::optional<std::uint64_t> parse_whole_number(std::string_view text);

} // namespace twiddle::record
