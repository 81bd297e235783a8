// SPDX-License-Identifier: MIT
#include "intersect/surfaces/self/self_pairs.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// In lengths of pieces; more than sides of boxes are shifted by.
constexpr double room_between = 4 * shift_of_sides;
// The largest length of a rectangle that holds two parts which are not adjacent, in lengths of the longer
// part.
constexpr double most_stretch = 3;

PieceRect rect_of(const CrossCell &cell) noexcept {
    PieceRect rect;
    const CrossPiece &piece = cell.piece();
    for (size_t k = 0; k < 2; ++k) {
        const auto index = static_cast<double>(piece.index[k]);
        const Interval &within = piece.within[k];
        const double part = within.upper - within.lower, upper = cell.lower(k) + cell.length(k);
        rect[k] = {index + within.lower + part * cell.lower(k),
                   index + (cell.is_border(k, 1) ? within.upper : within.lower + part * upper)};
    }
    return rect;
}

Interval hull(const Interval &a, const Interval &b) noexcept {
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

double length_of(const Interval &x) noexcept {
    return x.upper - x.lower;
}

// Whether both parts reach to the same pole.
bool have_one_pole(const CrossCell &a, const CrossCell &b) noexcept {
    const auto has = [](const CrossCell &cell, size_t axis, size_t end) {
        return cell.piece().poles[axis][end] && cell.is_border(axis, end);
    };
    for (size_t k = 0; k < 2; ++k) {
        for (size_t end = 0; end < 2; ++end) {
            if (has(a, k, end) && has(b, k, end)) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

// The interval that holds both; across the seam of an axis that closes if that is shorter.
Interval SelfPairs::both_along(size_t axis, const Interval &a, const Interval &b) const noexcept {
    const Interval both = hull(a, b);
    if (!ground_.borders.wraps(axis)) {
        return both;
    }
    const auto n = static_cast<double>(ground_.grid.count(static_cast<int>(axis)));
    const double shift = a.lower < b.lower ? -n : n;
    const Interval across = hull(a, {b.lower + shift, b.upper + shift});
    return length_of(across) < length_of(both) ? across : both;
}

bool SelfPairs::are_in_one_block(const CrossCell &a, const CrossCell &b) const {
    const int64_t block = injective_.block_of(a.piece().index);
    return block >= 0 && block == injective_.block_of(b.piece().index);
}

SelfPairs::Verdict SelfPairs::look(const CrossCell &a, const CrossCell &b) {
    count_work(40);
    if (are_in_one_block(a, b)) {
        return Verdict::one_sheet;
    }
    const PieceRect of_a = rect_of(a), of_b = rect_of(b);
    PieceRect both;
    bool touching = true, near = true;
    for (size_t k = 0; k < 2; ++k) {
        both[k] = both_along(k, of_a[k], of_b[k]);
        const double own = length_of(of_a[k]), other = length_of(of_b[k]), length = length_of(both[k]);
        touching = touching && length <= own + other + room_between;
        near = near && length <= most_stretch * std::max(own, other);
    }
    touching = touching || have_one_pole(a, b);
    if ((!touching && !near) || !injective_.is_continuous(both)) {
        return Verdict::apart;
    }
    if (injective_.is_proven(both)) {
        return Verdict::one_sheet;
    }
    return touching ? Verdict::touching : Verdict::near;
}

} // namespace nrb::intersect
