// SPDX-License-Identifier: MIT
// Reads numbers of a body, and checks them before they are used.
#pragma once

#include "io/binary/envelope.h"

#include <span>

namespace nrb::io {

// All throw Status::syntax for a number that is not as described, and what ByteReader throws. `what`: how
// messages name the number.

// A number of things that follow, each of which takes at least a byte.
int64_t size_from(ByteReader &reader, const char *what);
// An index from `least` to count - 1.
int64_t index_from(ByteReader &reader, int64_t least, int64_t count, const char *what);
// Flags, with no bits other than those of `known`.
uint64_t flags_from(ByteReader &reader, uint64_t known, const char *what);
double finite_from(ByteReader &reader, const char *what);
void finite_from(ByteReader &reader, std::span<double> values, const char *what);

} // namespace nrb::io
