// SPDX-License-Identifier: MIT
// What the distance does around a point to which an edge of a surface has collapsed.
#pragma once

#include "closest/foot.h"

namespace nrb::closest {

// Signs of how much larger it is than there, in cyclic order.
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
    // Whether the ring tells what the pole is.
    [[nodiscard]] bool decides() const noexcept {
        return (above_ > 0 && below_ > 0) || (equal_ == 0 && above_ + below_ > 0);
    }
    // A critical_ constant; 0 if the pole is not critical. Only extrema count in an open ring, as at corners.
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
