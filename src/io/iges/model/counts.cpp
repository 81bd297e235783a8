// SPDX-License-Identifier: MIT
#include "io/iges/model/counts.h"

#include "base/error.h"

namespace nrb::io::iges {

int64_t read_count(Record &record, const char *what, int64_t parameters) {
    const int64_t count = record.integer(what);
    if (count < 0 || count > record.remaining() / parameters) {
        fail(Status::syntax, "%s is %lld, and %lld parameters are left", what, static_cast<long long>(count),
             static_cast<long long>(record.remaining()));
    }
    return count;
}

std::vector<int64_t> read_pointers(Record &record, const char *what) {
    std::vector<int64_t> result(static_cast<size_t>(read_count(record, what, 1)));
    for (int64_t &pointer : result) {
        pointer = record.integer(what);
    }
    return result;
}

} // namespace nrb::io::iges
