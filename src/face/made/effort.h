// SPDX-License-Identifier: MIT
// What the curves that a face lacks may cost.
#pragma once

#include "base/error.h"
#include "spline/spline.h"

namespace nrb::face {

// Points of curves and surfaces, and pieces of surfaces that are looked at for nearest ones, each less than a microsecond: more than
// edges take that lie on their surface, so that others come to an end.
class Effort {
public:
    // For one more edge, or curve.
    void allow(const Spline &given) noexcept {
        constexpr int64_t for_each = 65536, for_a_point = 256;
        allowed_ += for_each + for_a_point * given.point_count();
    }
    // Throws Status::not_converged.
    void spend(int64_t points) {
        spent_ += points;
        if (spent_ > allowed_) {
            fail(Status::not_converged, "the curves that are missing take more than %lld points",
                 static_cast<long long>(allowed_));
        }
    }

private:
    int64_t allowed_ = 1000000, spent_ = 0;
};

} // namespace nrb::face
