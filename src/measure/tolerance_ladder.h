// SPDX-License-Identifier: MIT
// Tolerances below rounding ask for what double precision and the limit of work give.
#pragma once

#include <algorithm>
#include <limits>

namespace nrb::measure {

// The tolerances that are tried one after the other, relative: the one asked for, and if that is below
// rounding, one of nine digits and one of three. What does not reach these is taken for infinite.
class Reach {
public:
    explicit Reach(double asked) noexcept
        : tolerance_(std::clamp(asked, rounding, 0.5)), best_(asked < rounding) {}

    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
    // False if there is none left.
    bool loosen() noexcept {
        tolerance_ *= step;
        return best_ && tolerance_ <= loosest;
    }

private:
    static constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    static constexpr double step = 0x1p20, loosest = 1e-3;

    double tolerance_;
    bool best_;
};

} // namespace nrb::measure
