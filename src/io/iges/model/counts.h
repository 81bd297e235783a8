// SPDX-License-Identifier: MIT
// Lists inside of parameter data.
#pragma once

#include "io/iges/record.h"

#include <vector>

namespace nrb::io::iges {

// The next parameter as the length of a list of entries with so many parameters each. Throws Status::syntax if they are not
// there.
int64_t read_count(Record &record, const char *what, int64_t parameters);

std::vector<int64_t> read_pointers(Record &record, const char *what);

} // namespace nrb::io::iges
