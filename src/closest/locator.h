// SPDX-License-Identifier: MIT
// The interface for closest-point queries on one spline. The locator is kept with the spline.
#pragma once

#include "closest/foot.h"

#include <cmath>
#include <vector>

namespace nrb::closest {

struct CriticalSet {
    std::vector<CriticalPoint> points; // in the order of their parameters
    int32_t status = 0;                // closest_ bits

    // Withdraws the certificate if a distance has overflowed.
    void revoke_infinite() noexcept {
        for (const CriticalPoint &point : points) {
            if (!std::isfinite(point.foot.distance)) {
                status &= ~closest_certified;
            }
        }
    }
};

// Immutable, so that any number of threads may query it at once.
class Locator {
public:
    Locator() = default;
    Locator(const Locator &) = delete;
    Locator &operator=(const Locator &) = delete;
    virtual ~Locator() = default;

    // The nearest or farthest point. Distances are measured to the Bezier pieces, which agree with the spline
    // to rounding.
    [[nodiscard]] virtual Foot nearest(const Query &query) const = 0;
    // The local minimum that a descent from `guess`, a place in the domain, reaches.
    [[nodiscard]] virtual Foot local(const double *point, const double *guess) const = 0;
    // All critical points of the distance. Critical points no farther apart than query.tolerance count as
    // one; of a curve, those that follow each other, so that a place where it crosses itself is two points.
    [[nodiscard]] virtual CriticalSet critical(const Query &query) const = 0;
    // The minima whose distance exceeds the smallest one by at most query.tolerance.
    [[nodiscard]] virtual CriticalSet minima(const Query &query) const = 0;
};

// Built at the first use.
const Locator &locator_of(const Spline &spline);

} // namespace nrb::closest
