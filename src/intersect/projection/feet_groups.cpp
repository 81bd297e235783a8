// SPDX-License-Identifier: MIT
#include "intersect/projection/feet_groups.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr Interval all_numbers{-infinity, infinity}, no_number{infinity, -infinity};

RangesInSpace united(const RangesInSpace &a, const RangesInSpace &b) noexcept {
    RangesInSpace both;
    for (size_t c = 0; c < 3; ++c) {
        both[c] = {std::min(a[c].lower, b[c].lower), std::max(a[c].upper, b[c].upper)};
    }
    return both;
}

RangesInSpace box_of(const pieces::BezierPiece &piece) noexcept {
    const double room = piece.moved() + 4 * eps * piece.reach();
    RangesInSpace box;
    for (size_t c = 0; c < 3; ++c) {
        box[c] = {piece.lower()[c] - room, piece.upper()[c] + room};
    }
    return box;
}

RangesInSpace box_of(const RoundedPolynomial &vectors) noexcept {
    RangesInSpace box;
    box.fill(no_number);
    for (size_t i = 0; i < vectors.values.size(); ++i) {
        const double x = vectors.values[i], room = vectors.error(i);
        Interval &side = box[i % 3];
        side = {std::min(side.lower, x - room), std::max(side.upper, x + room)};
    }
    return box;
}

Interval product(const Interval &a, const Interval &b) noexcept {
    const std::array<double, 4> all{a.lower * b.lower, a.lower * b.upper, a.upper * b.lower,
                                    a.upper * b.upper};
    const auto [least, most] = std::ranges::minmax(all);
    return {least, most};
}

} // namespace

FeetGroups::FeetGroups(CrossGround &ground) : ground_(ground), of_curve_(false) {
    add({0, 0}, {ground.grid.count(0), ground.grid.count(1)});
}

FeetGroups::FeetGroups(CrossGround &lines, const Spline &curve, const pieces::Frame &frame)
    : ground_(lines), of_curve_(true) {
    const pieces::FramedPieces framed(pieces::piece_tree_of(curve), frame);
    const int64_t n = lines.grid.count(0);
    for (int64_t i = 0; i < n; ++i) {
        curve_.push_back(framed.piece(i));
        count_work(100);
    }
    add({0, 0}, {n, 1});
}

int64_t FeetGroups::add(const std::array<int64_t, 2> &first, const std::array<int64_t, 2> &last) {
    FeetGroup group{first, last, {}, {}, {}, {-1, -1}, nullptr};
    if (group.pieces() == 1) {
        set_piece(group);
    } else {
        const size_t axis = last[0] - first[0] >= last[1] - first[1] ? 0 : 1;
        std::array<int64_t, 2> middle_last = last, middle_first = first;
        middle_last[axis] = middle_first[axis] = first[axis] + (last[axis] - first[axis]) / 2;
        group.halves = {add(first, middle_last), add(middle_first, last)};
        const FeetGroup &a = half(group, 0), &b = half(group, 1);
        group.points = united(a.points, b.points);
        for (size_t k = 0; k < 2; ++k) {
            group.tangents[k] = united(a.tangents[k], b.tangents[k]);
            group.speeds[k] = std::max(a.speeds[k], b.speeds[k]);
        }
    }
    groups_.push_back(group);
    return std::ssize(groups_) - 1;
}

const pieces::BezierPiece *FeetGroups::numbers_of(const FeetGroup &group) {
    if (of_curve_) {
        const pieces::BezierPiece &piece = curve_[static_cast<size_t>(group.first[0])];
        return piece.positive() ? &piece : nullptr;
    }
    const CrossPiece *const piece = ground_.piece({group.first[0], group.first[1]});
    return piece == nullptr ? nullptr : &piece->piece;
}

void FeetGroups::set_piece(FeetGroup &group) {
    group.points.fill(all_numbers);
    group.tangents = {group.points, group.points};
    const pieces::BezierPiece *const numbers = numbers_of(group);
    if (numbers == nullptr) {
        return;
    }
    group.points = box_of(*numbers);
    for (int k = 0; k < (of_curve_ ? 1 : 2); ++k) {
        const auto i = static_cast<size_t>(k);
        const double length =
            ground_.grid.break_at(k, group.first[i] + 1) - ground_.grid.break_at(k, group.first[i]);
        group.speeds[i] = largest_speed(*numbers, i) / length;
    }
    if (of_curve_) {
        return;
    }
    count_work(200 * numbers->coefficients());
    if (const auto tangents = tangents_of(*ground_.piece({group.first[0], group.first[1]}))) {
        for (size_t k = 0; k < 2; ++k) {
            group.tangents[k] = box_of((*tangents)[k]);
        }
    }
}

FeetCell *FeetGroups::cell(FeetGroup &group) {
    const CrossPiece *const piece = ground_.piece({group.first[0], group.first[1]});
    if (group.cell != nullptr || piece == nullptr || numbers_of(group) == nullptr) {
        return group.cell;
    }
    if (of_curve_) {
        nets_.push_back(feet_net_of(*numbers_of(group), *piece));
    } else if (auto net = feet_net_of(*piece)) {
        nets_.push_back(std::move(*net));
    } else {
        return nullptr;
    }
    count_work(static_cast<int64_t>(20 * nets_.back().values.size()));
    group.cell = &cells_.emplace_back(nets_.back());
    return group.cell;
}

bool have_no_feet(const FeetGroup &surface, const FeetGroup &curve) {
    count_work(60);
    for (const RangesInSpace &tangents : surface.tangents) {
        Interval sum{0, 0};
        double size = 0;
        for (size_t c = 0; c < 3; ++c) {
            const Interval &s = surface.points[c], &x = curve.points[c],
                           part = product({s.lower - x.upper, s.upper - x.lower}, tangents[c]);
            sum = {sum.lower + part.lower, sum.upper + part.upper};
            size += std::max(std::abs(part.lower), std::abs(part.upper));
        }
        const double room = 16 * eps * size;
        if (sum.lower > room || sum.upper < -room) {
            return true;
        }
    }
    return false;
}

} // namespace nrb::intersect
