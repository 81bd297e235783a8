// SPDX-License-Identifier: MIT
// Classifies a pole of a surface by the signs of (distance at a ring of points around it) - (distance at the
// pole).
#pragma once

#include "closest/foot.h"

namespace nrb::closest {

// The signs are added in cyclic order.
class PoleRing {
public:
    void add(int sign) noexcept {
        ++(sign > 0 ? above_ : sign < 0 ? below_ : equal_);
        if (sign == 0) {
            return;
        }
        changes_ += last_ != 0 && last_ != sign ? 1 : 0;
        first_ = first_ == 0 ? sign : first_;
        last_ = sign;
    }
    // Whether the signs determine what the pole is.
    [[nodiscard]] bool decides() const noexcept {
        return (above_ > 0 && below_ > 0) || (equal_ == 0 && above_ + below_ > 0);
    }
    // A critical_ constant; 0 if the pole is not critical. In an open ring, as at a corner, only extrema
    // count.
    [[nodiscard]] int32_t kind(bool closed) const noexcept {
        if (above_ > 0 && below_ > 0) {
            return closed && changes_ + (first_ != last_ ? 1 : 0) > 2 ? critical_saddle : 0;
        }
        return above_ > 0 ? critical_minimum : critical_maximum;
    }

private:
    int above_ = 0, below_ = 0, equal_ = 0, changes_ = 0;
    int first_ = 0, last_ = 0;
};

} // namespace nrb::closest
