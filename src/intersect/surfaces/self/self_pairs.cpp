// SPDX-License-Identifier: MIT
#include "intersect/surfaces/self/self_pairs.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// In parts of pieces: sides of boxes are shifted by less.
constexpr double room_between = 4 * shift_of_sides;
// How much longer than the longer of both what holds them may be, if they are not side by side.
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

// Whether both reach to one side of the surface that is one point.
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

SelfPairs::Verdict SelfPairs::look(const CrossCell &a, const CrossCell &b) {
    count_work(40);
    const int64_t block = injective_.block_of(a.piece().index);
    if (block >= 0 && block == injective_.block_of(b.piece().index)) {
        return Verdict::one_sheet;
    }
    const PieceRect of_a = rect_of(a), of_b = rect_of(b);
    PieceRect both;
    bool touching = true, near = true;
    for (size_t k = 0; k < 2; ++k) {
        const auto n = static_cast<double>(ground_.grid.count(static_cast<int>(k)));
        both[k] = hull(of_a[k], of_b[k]);
        if (ground_.borders.wraps(k) && length_of(both[k]) > n / 2) {
            const double shift = of_a[k].lower < of_b[k].lower ? -n : n;
            const Interval across = hull(of_a[k], {of_b[k].lower + shift, of_b[k].upper + shift});
            both[k] = length_of(across) < length_of(both[k]) ? across : both[k];
        }
        const double lengths = length_of(of_a[k]) + length_of(of_b[k]);
        touching = touching && length_of(both[k]) <= lengths + room_between;
        near = near && length_of(both[k]) <= most_stretch * std::max(length_of(of_a[k]), length_of(of_b[k]));
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
