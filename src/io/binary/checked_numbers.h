// SPDX-License-Identifier: MIT
// Numbers of a body that are looked at before they are used.
#pragma once

#include "io/binary/envelope.h"

#include <span>

namespace nrb::io {

// All throw Status::syntax, naming the number, for one that is not what they say.

// How many things follow, of which each takes at least a byte.
int64_t size_from(ByteReader &reader, const char *what);
// From `least` to count - 1.
int64_t index_from(ByteReader &reader, int64_t least, int64_t count, const char *what);
// Of these bits only.
uint64_t flags_from(ByteReader &reader, uint64_t known, const char *what);
double finite_from(ByteReader &reader, const char *what);
void finite_from(ByteReader &reader, std::span<double> values, const char *what);

} // namespace nrb::io
