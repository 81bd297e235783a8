// SPDX-License-Identifier: MIT
// Names in files of meshes.
#pragma once

#include <string>
#include <string_view>

namespace nrb::io {

// A JSON string, with its quotes. Bytes that are no UTF-8 are taken for ISO 8859-1.
std::string json_text(std::string_view name);

// A name as one word: blanks and control characters become '_'.
std::string one_word(std::string_view name);

} // namespace nrb::io
