// SPDX-License-Identifier: MIT
// Files as bytes.
#pragma once

#include <cstdint>
#include <vector>

namespace nrb::io {

// The contents of a file; throws Error: Status::file, or Status::too_large beyond max_bytes.
std::vector<char> read_whole_file(const char *path, int64_t max_bytes);

} // namespace nrb::io
