// SPDX-License-Identifier: MIT
// Strings of an exchange structure as UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace nrb::io::step {

// The string that stands between two apostrophes: '' is an apostrophe and \\ a backslash; \X\hh, \X2\hhhh...\X0\,
// \X4\hhhhhhhh...\X0\ and \S\c (in the part of ISO 8859 that \P.\ names) are characters. An escape that is none
// stays as it is. Bytes beyond ASCII are UTF-8 if the whole string is, otherwise ISO 8859-1. Line ends do not count;
// other control characters become '?', so that the result is whole as a C string.
std::string decode_string(std::string_view raw);

// Bytes of the UTF-8 character that a text begins with; 0: it begins with none.
size_t utf8_length(std::string_view text) noexcept;
bool is_utf8(std::string_view text) noexcept;

// Appends what decode_string() makes this text of, in ASCII: beyond it, characters become \X2\hhhh...\X0\ and
// \X4\hhhhhhhh...\X0\. A text that is not UTF-8 is taken for ISO 8859-1, and control characters become '?'.
void append_encoded(std::string_view text, std::string &raw);

} // namespace nrb::io::step
