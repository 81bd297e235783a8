// SPDX-License-Identifier: MIT
// Names in files of meshes.
#pragma once

#include <string>
#include <string_view>

namespace nrb::io {

// A JSON string, with its quotes. Bytes that are no UTF-8 are taken for ISO 8859-1.
std::string json_text(std::string_view name);

// A name as one word of a line: blanks, control characters, bytes that are no UTF-8, and what readers take for the start of a comment
// or for a line that goes on ('#' and a backslash) become '_'.
std::string one_word(std::string_view name);

} // namespace nrb::io
