// SPDX-License-Identifier: MIT
// Refuses results that overflow.
#pragma once

#include "base/error.h"
#include "base/finite.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace nrb::inline base {

// Throws Status::not_representable unless all values are finite; `what` names them in the message.
inline void require_representable(std::span<const double> values, const char *what) {
    if (!all_finite(values)) {
        const auto bad =
            std::find_if_not(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
        fail(Status::not_representable, "%s: value %lld of the result overflows", what,
             static_cast<long long>(bad - values.begin()));
    }
}

} // namespace nrb::inline base
