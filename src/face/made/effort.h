// SPDX-License-Identifier: MIT
// The limit of work for making the curves that a face lacks.
#pragma once

#include "base/error.h"
#include "spline/spline.h"

namespace nrb::face {

// Counts points of curves and surfaces, and pieces of surfaces that searches for nearest points examine; each
// takes less than a microsecond. More is allowed than edges on their surface take, so that only other edges
// reach the limit.
class Effort {
public:
    // Allows the work for one more edge or curve.
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
