// SPDX-License-Identifier: MIT
// Numbers and words of an IGES file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nrb::io::iges {

// Without blanks at both ends.
std::string_view trim(std::string_view text) noexcept;

// For messages: at most 24 characters, those that do not print replaced by '?'.
std::string excerpt(std::string_view text);

// For names: control characters replaced by '?', so that the text is whole as a C string.
std::string printable(std::string_view text);

// An optional sign and digits, nothing else; false if the text is not that or does not fit.
bool parse_integer(std::string_view text, int64_t &value) noexcept;

// A real constant of IGES: decimal digits with an optional point and an optional exponent marked E or D.
// Correctly rounded, whatever the locale; values too small for double precision become zero, values too large
// are refused.
bool parse_real(std::string_view text, double &value);

} // namespace nrb::io::iges
