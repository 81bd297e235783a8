// SPDX-License-Identifier: MIT
// The tolerances that an integral is computed to, one after the other.
#pragma once

#include "base/numbers.h"

#include <algorithm>

namespace nrb::measure {

// Relative tolerances. First comes the one that the caller gives. If that is below rounding, the caller wants
// the best that double precision and the limit of work allow: then nine digits are tried next, and three
// digits last. An integral that does not converge to three digits is taken for infinite.
class ToleranceLadder {
public:
    explicit ToleranceLadder(double tolerance) noexcept
        : tolerance_(std::clamp(tolerance, rounding, 0.5)), best_(tolerance < rounding) {}

    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
    // False if no tolerance is left.
    bool loosen() noexcept {
        tolerance_ *= step;
        return best_ && tolerance_ <= loosest;
    }

private:
    static constexpr double rounding = 4 * eps;
    static constexpr double step = 0x1p20, loosest = 1e-3;

    double tolerance_;
    bool best_;
};

} // namespace nrb::measure
