// SPDX-License-Identifier: MIT
// Reads and writes whole files as bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace nrb::io {

// Receives the contents of a file from start to end, in blocks.
using ByteSink = std::function<void(std::string_view)>;
// Passes the whole contents of a file to a sink: the same bytes at every call.
using ByteSource = std::function<void(const ByteSink &)>;

// The contents of a file. Throws Error: Status::file, or Status::too_large for more than max_bytes.
std::vector<char> read_whole_file(const char *path, int64_t max_bytes);

// Creates or replaces a file, as a whole or not at all: the bytes go to a new file in the same directory,
// which is renamed to the path when they are on the disk. A symbolic link to an existing file is kept, and
// the file that it leads to is replaced. Devices and pipes are written to directly. Throws Error:
// Status::file, and what ends a watched call; then the old file is unchanged, and the new one is removed.
void write_whole_file(const char *path, std::string_view bytes);
// The same for bytes that are never in memory all at once. Also throws what the source throws.
void write_whole_file(const char *path, const ByteSource &source);

} // namespace nrb::io
