// SPDX-License-Identifier: MIT
// The sequence of tolerances that an integral is tried with.
#pragma once

#include "base/numbers.h"

#include <algorithm>

namespace nrb::measure {

// The first relative tolerance is that of the caller. If it is below rounding, the caller wants the best that
// double precision and the limit of work allow: then nine digits are tried next, six digits after that, and
// three digits last. An integral that does not converge to three digits is considered infinite.
class ToleranceLadder {
public:
    explicit ToleranceLadder(double tolerance) noexcept
        : tolerance_(std::clamp(tolerance, rounding, 0.5)), best_(tolerance < rounding) {}

    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
    // A search with the current tolerance may do the part 1 / shares() of the work: little at the level of
    // rounding, which few integrals reach, and all for the last tolerance.
    [[nodiscard]] int shares() const noexcept { return best_ ? parts[rung_] : 1; }
    // Goes on to the next tolerance; false if none is left.
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
