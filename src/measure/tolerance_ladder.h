// SPDX-License-Identifier: MIT
// The tolerances that an integral is computed to, one after the other.
#pragma once

#include "base/numbers.h"

#include <algorithm>

namespace nrb::measure {

// Relative tolerances. First comes the one that the caller gives. If that is below rounding, the caller wants
// the best that double precision and the limit of work allow: then nine digits are tried next, six after them, and
// three digits last. An integral that does not converge to three digits is taken for infinite.
class ToleranceLadder {
public:
    explicit ToleranceLadder(double tolerance) noexcept
        : tolerance_(std::clamp(tolerance, rounding, 0.5)), best_(tolerance < rounding) {}

    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
    // The part 1 / n of the limit of work that may be spent on this one: little on rounding, which few integrals reach,
    // and all on the last.
    [[nodiscard]] int shares() const noexcept { return best_ ? parts[rung_] : 1; }
    // False if no tolerance is left.
    bool loosen() noexcept {
        tolerance_ *= rung_ == 0 ? first_step : step;
        ++rung_;
        return best_ && tolerance_ <= loosest;
    }

private:
    static constexpr double rounding = 4 * eps;
    static constexpr double first_step = 0x1p20, step = 0x1p10, loosest = 1e-3;

    static constexpr int parts[] = {8, 2, 4, 1, 1};

    double tolerance_;
    bool best_;
    int rung_ = 0;
};

} // namespace nrb::measure
