// SPDX-License-Identifier: MIT
// Structs of the caller, whose header may have more or fewer fields than this library knows.
#pragma once

#include "checks.h"

#include <algorithm>
#include <cstdint>

namespace nrb::capi {

// Throws NURBS_ERROR_OPTIONS unless `size`, the struct_size that the caller states, is one that a release has
// or may have. `smallest`: the size in the first release that has the struct.
void check_struct_size(const char *name, int64_t size, int64_t smallest);
// Throws NURBS_ERROR_OPTIONS unless the bytes from `known` to `size`, fields of newer headers, are 0.
void check_unknown_fields(const char *name, const void *bytes, int64_t known, int64_t size);

// Checks a struct that is read: not NULL, of a possible size, and 0 in the fields that this library lacks.
template <class Struct>
const Struct &checked_struct(const char *name, const Struct *given, int64_t smallest = sizeof(Struct)) {
    require(given, name);
    check_struct_size(name, given->struct_size, smallest);
    check_unknown_fields(name, given, sizeof(Struct), given->struct_size);
    return *given;
}

// Sets all fields but the size to 0, including those of newer headers, where 0 means that nothing new is
// wanted.
template <class Struct>
void clear_struct(const char *name, Struct *given, int64_t size, int64_t smallest = sizeof(Struct)) {
    require(given, name);
    check_struct_size(name, size, smallest);
    std::fill_n(reinterpret_cast<unsigned char *>(given), size, static_cast<unsigned char>(0));
    given->struct_size = size;
}

} // namespace nrb::capi
