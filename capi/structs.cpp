// SPDX-License-Identifier: MIT
#include "structs.h"

#include "base/error.h"

#include <algorithm>

namespace nrb::capi {

namespace {

// No release will have a larger struct: a larger size is garbage rather than that of a newer header.
constexpr int64_t largest = 4096;

} // namespace

void check_struct_size(const char *name, int64_t size, int64_t smallest) {
    if (size < smallest || size > largest) {
        fail(Status::options, "%s: struct_size = %lld, expected %lld to %lld", name,
             static_cast<long long>(size), static_cast<long long>(smallest), static_cast<long long>(largest));
    }
}

void check_unknown_fields(const char *name, const void *bytes, int64_t known, int64_t size) {
    const auto *first = static_cast<const unsigned char *>(bytes);
    if (std::any_of(first + known, first + std::max(known, size),
                    [](unsigned char byte) { return byte != 0; })) {
        fail(Status::options, "%s: fields beyond byte %lld are unknown to this version and not zero", name,
             static_cast<long long>(known));
    }
}

} // namespace nrb::capi
