// SPDX-License-Identifier: MIT
// Points in single precision.
#pragma once

#include "base/error.h"
#include "numeric/vector3.h"

#include <array>
#include <cmath>

namespace nrb::io {

using Single3 = std::array<float, 3>;

inline Single3 single(const Vector3 &x) noexcept {
    return {static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)};
}

[[noreturn]] inline void fail_single(const Vector3 &x) {
    fail(Status::not_representable, "a coordinate overflows in single precision: (%s, %s, %s)",
         Number(x.x).text, Number(x.y).text, Number(x.z).text);
}

// Throws Status::not_representable if a coordinate overflows.
inline Single3 checked_single(const Vector3 &x) {
    const Single3 rounded = single(x);
    if (!(std::isfinite(rounded[0]) && std::isfinite(rounded[1]) && std::isfinite(rounded[2]))) {
        fail_single(x);
    }
    return rounded;
}

} // namespace nrb::io
