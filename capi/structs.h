// SPDX-License-Identifier: MIT
// Structs of the caller, who may know more or fewer fields than this library.
#pragma once

#include "checks.h"

#include <algorithm>
#include <cstdint>

namespace nrb::capi {

// Throws NURBS_ERROR_OPTIONS unless `size`, the struct_size that the caller states, is one that a release has or
// may have. `smallest` is that of the first release.
void check_struct_size(const char *name, int64_t size, int64_t smallest);
// The bytes that this library does not know have to be 0.
void check_unknown_fields(const char *name, const void *bytes, int64_t known, int64_t size);

// A struct that is read: not NULL, of a possible size, without unknown fields.
template <class Struct>
const Struct &checked_struct(const char *name, const Struct *given, int64_t smallest = sizeof(Struct)) {
    require(given, name);
    check_struct_size(name, given->struct_size, smallest);
    check_unknown_fields(name, given, sizeof(Struct), given->struct_size);
    return *given;
}

// All fields 0 but the size, those of newer headers too: 0 means that nothing new is wanted.
template <class Struct>
void clear_struct(const char *name, Struct *given, int64_t size, int64_t smallest = sizeof(Struct)) {
    require(given, name);
    check_struct_size(name, size, smallest);
    std::fill_n(reinterpret_cast<unsigned char *>(given), size, static_cast<unsigned char>(0));
    given->struct_size = size;
}

} // namespace nrb::capi
