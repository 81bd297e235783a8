// SPDX-License-Identifier: MIT
// The tolerance of an approximate operation.
#pragma once

#include "base/error.h"

namespace nrb::inline base {

// tolerance >= 0, else Status::tolerance.
inline void check_tolerance(double tolerance, const char *name = "tolerance") {
    if (!(tolerance >= 0)) {
        fail(Status::tolerance, "%s = %s, expected >= 0", name, Number(tolerance).text);
    }
}

// tolerance > 0, else Status::tolerance.
inline void check_positive_tolerance(double tolerance) {
    if (!(tolerance > 0)) {
        fail(Status::tolerance, "tolerance = %s, expected > 0", Number(tolerance).text);
    }
}

} // namespace nrb::inline base
