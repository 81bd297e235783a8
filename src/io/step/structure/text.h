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

} // namespace nrb::io::step
