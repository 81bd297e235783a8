// SPDX-License-Identifier: MIT
// Files as bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace nrb::io {

// Takes a file from its start to its end, in blocks.
using ByteSink = std::function<void(std::string_view)>;
// Gives a sink all of a file, the same every time.
using ByteSource = std::function<void(const ByteSink &)>;

// The contents of a file; throws Error: Status::file, or Status::too_large beyond max_bytes.
std::vector<char> read_whole_file(const char *path, int64_t max_bytes);

// Makes a file of these bytes, or replaces one, whole or not at all: they are written to a new file beside it, which takes its name
// when they are on the disk. A link stays, and what it leads to is replaced; devices and pipes are written to as they are. Throws
// Error: Status::file, and what ends a watched call; then the old file is as it was, and nothing is left of the new one.
void write_whole_file(const char *path, std::string_view bytes);
// The same of bytes that nobody holds at once. Throws what the source throws, too.
void write_whole_file(const char *path, const ByteSource &source);

} // namespace nrb::io
