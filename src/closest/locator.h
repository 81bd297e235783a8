// SPDX-License-Identifier: MIT
// Finds closest points of one spline, which keeps it.
#pragma once

#include "closest/foot.h"

#include <cmath>
#include <vector>

namespace nrb::closest {

struct CriticalSet {
    std::vector<CriticalPoint> points; // in the order of their parameters
    int32_t status = 0;                // closest_ bits

    // Nothing is certified of a distance that overflows.
    void revoke_infinite() noexcept {
        for (const CriticalPoint &point : points) {
            if (!std::isfinite(point.foot.distance)) {
                status &= ~closest_certified;
            }
        }
    }
};

// Immutable: any number of threads may ask at once.
class Locator {
public:
    Locator() = default;
    Locator(const Locator &) = delete;
    Locator &operator=(const Locator &) = delete;
    virtual ~Locator() = default;

    // The nearest or farthest point. Distances are those of the Bezier pieces, which are those of the spline
    // to rounding.
    [[nodiscard]] virtual Foot nearest(const Query &query) const = 0;
    // The local minimum that a descent from a guess in the domain reaches.
    [[nodiscard]] virtual Foot local(const double *point, const double *guess) const = 0;
    // All critical points of the distance; query.tolerance is the distance up to which they count as one.
    [[nodiscard]] virtual CriticalSet critical(const Query &query) const = 0;
    // The minima that are farther than the nearest point by at most query.tolerance.
    [[nodiscard]] virtual CriticalSet minima(const Query &query) const = 0;
};

// Built at the first use.
const Locator &locator_of(const Spline &spline);

} // namespace nrb::closest
