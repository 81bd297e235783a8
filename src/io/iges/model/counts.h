// SPDX-License-Identifier: MIT
// Lists inside parameter data.
#pragma once

#include "io/iges/record.h"

#include <vector>

namespace nrb::io::iges {

// Reads the length of a list whose entries have `parameters` parameters each. Throws Status::syntax if they
// are not all there.
int64_t read_count(Record &record, const char *what, int64_t parameters);

std::vector<int64_t> read_pointers(Record &record, const char *what);

} // namespace nrb::io::iges
