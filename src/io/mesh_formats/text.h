// SPDX-License-Identifier: MIT
// Names as text in mesh files.
#pragma once

#include <string>
#include <string_view>

namespace nrb::io {

// A JSON string with its quotes. Bytes that are not UTF-8 are taken as ISO 8859-1.
std::string json_text(std::string_view name);

// A name as one word of a line. Blanks, control characters, bytes that are not UTF-8, and characters that
// readers take for the start of a comment or for the continuation of a line ('#' and the backslash) become
// '_'.
std::string one_word(std::string_view name);

} // namespace nrb::io
