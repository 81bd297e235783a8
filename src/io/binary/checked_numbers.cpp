// SPDX-License-Identifier: MIT
#include "io/binary/checked_numbers.h"

#include "base/error.h"

#include <cmath>

namespace nrb::io {

int64_t size_from(ByteReader &reader, const char *what) {
    const int64_t size = reader.take_integer();
    if (size < 0 || static_cast<uint64_t>(size) > reader.left()) {
        fail(Status::syntax, "%s = %lld, expected 0 to %zu, for the bytes that follow", what,
             static_cast<long long>(size), reader.left());
    }
    return size;
}

int64_t index_from(ByteReader &reader, int64_t least, int64_t count, const char *what) {
    const int64_t index = reader.take_integer();
    if (index < least || index >= count) {
        fail(Status::syntax, "%s %lld, expected %lld to %lld", what, static_cast<long long>(index),
             static_cast<long long>(least), static_cast<long long>(count) - 1);
    }
    return index;
}

uint64_t flags_from(ByteReader &reader, uint64_t known, const char *what) {
    const uint64_t flags = reader.take();
    if ((flags & ~known) != 0) {
        fail(Status::syntax, "%s 0x%llx, expected bits of 0x%llx", what,
             static_cast<unsigned long long>(flags), static_cast<unsigned long long>(known));
    }
    return flags;
}

double finite_from(ByteReader &reader, const char *what) {
    const double value = reader.take_double();
    if (!std::isfinite(value)) {
        fail(Status::syntax, "%s %s is not finite", what, Number(value).text);
    }
    return value;
}

void finite_from(ByteReader &reader, std::span<double> values, const char *what) {
    for (double &value : values) {
        value = finite_from(reader, what);
    }
}

} // namespace nrb::io
