// SPDX-License-Identifier: MIT
// Checks that results have not overflowed.
#pragma once

#include "base/error.h"
#include "base/finite.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace nrb::inline base {

// Throws Status::not_representable unless all values are finite; `what` names them in the message.
inline void require_representable(std::span<const double> values, const char *what) {
    constexpr size_t part = size_t{1} << 20;
    bool finite = true;
    for (size_t first = 0; first < values.size() && finite; first += part) {
        const auto some = values.subspan(first, std::min(part, values.size() - first));
        count_work(std::ssize(some) / 4);
        finite = all_finite(some);
    }
    if (!finite) {
        const auto bad =
            std::find_if_not(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
        fail(Status::not_representable, "%s: value %lld of the result overflows", what,
             static_cast<long long>(bad - values.begin()));
    }
}

} // namespace nrb::inline base
