// SPDX-License-Identifier: MIT
// Files as bytes.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace nrb::io {

// The contents of a file; throws Error: Status::file, or Status::too_large beyond max_bytes.
std::vector<char> read_whole_file(const char *path, int64_t max_bytes);

// Makes a file of these bytes, or replaces one, whole or not at all: they are written to a new file beside it, which takes its name
// when they are on the disk. A link stays, and what it leads to is replaced; devices and pipes are written to as they are. Throws
// Error: Status::file, and what ends a watched call; then the old file is as it was, and nothing is left of the new one.
void write_whole_file(const char *path, std::string_view bytes);

} // namespace nrb::io
