/* SPDX-License-Identifier: MIT */
// The bytes that this program holds, those of the libraries that it loads too: malloc and its family are replaced, with
// glibc's own underneath.
#ifndef NURBS_TESTS_CAPI_RANDOM_HELD_H
#define NURBS_TESTS_CAPI_RANDOM_HELD_H

#include <cstdint>

namespace held {

extern int64_t now, peak;

} // namespace held

#endif
