// SPDX-License-Identifier: MIT
// Parses numbers and words of an IGES file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nrb::io::iges {

// The text without blanks at both ends.
std::string_view trim(std::string_view text) noexcept;

// For messages: at most 24 characters; unprintable ones are replaced by '?'.
std::string excerpt(std::string_view text);

// For names: control characters are replaced by '?', so that no zero byte ends the text as a C string.
std::string printable(std::string_view text);

// An optional sign and digits, nothing else; false for any other text, and if the value does not fit.
bool parse_integer(std::string_view text, int64_t &value) noexcept;

// A real constant of IGES: decimal digits with an optional point and an optional exponent marked E or D.
// Correctly rounded, independent of the locale; values too small for double precision become zero, values too
// large are refused.
bool parse_real(std::string_view text, double &value);

} // namespace nrb::io::iges
