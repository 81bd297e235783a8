// Files as bytes.
#pragma once

#include <cstdint>
#include <vector>

namespace nrb {

// The contents of a file; throws Error: NURBS_ERROR_FILE, or NURBS_ERROR_TOO_LARGE beyond max_bytes.
std::vector<char> read_whole_file(const char *path, int64_t max_bytes);

} // namespace nrb
