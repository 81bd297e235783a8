// SPDX-License-Identifier: MIT
#include "intersect/surfaces/shear/cross_shear.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// Ranges of places along both axes, as differences from a place: of the wide part, and of the box with its
// room for arcs along borders.
std::array<Interval, 2> wide_ranges(const std::array<double, 2> &from) noexcept {
    return {Interval{-widening - from[0], 1 + widening - from[0]},
            Interval{-widening - from[1], 1 + widening - from[1]}};
}

std::array<Interval, 2> box_ranges(const CrossCell &cell, const std::array<double, 2> &from) noexcept {
    const auto along = [&](size_t k) {
        return Interval{cell.side(k, 0) - cell.room(k, 0) - from[k],
                        cell.side(k, 1) + cell.room(k, 1) - from[k]};
    };
    return {along(0), along(1)};
}

std::array<Vector3, 2> slopes_of(const CrossCell &cell, const CrossPiece::Point &point) noexcept {
    return {cell.length(0) * point.slope[0], cell.length(1) * point.slope[1]};
}

} // namespace

bool CrossShear::set_vectors(const Vector3 &along_0, const Vector3 &along_1) noexcept {
    const Vector3 across = cross(along_0, along_1);
    const double squared = dot(across, across);
    if (!(squared > 0x1p-40 * dot(along_0, along_0) * dot(along_1, along_1))) {
        return false;
    }
    vectors_ = {(1 / squared) * cross(along_1, across), (1 / squared) * cross(across, along_0),
                (1 / std::sqrt(squared)) * across};
    for (size_t d = 0; d < 3; ++d) {
        lengths_[d] = 1.0001 * length(vectors_[d]);
    }
    return true;
}

void CrossShear::set_leans() noexcept {
    for (size_t i = 0; i < 2; ++i) {
        for (size_t j = 0; j < 2; ++j) {
            leans_[i][j] = dot(vectors_[i], slopes_of_x_[j]);
        }
    }
    const double ad = leans_[0][0] * leans_[1][1], bc = leans_[0][1] * leans_[1][0], determinant = ad - bc;
    has_inverse_ = std::abs(determinant) > 0x1p-10 * (std::abs(ad) + std::abs(bc));
    inverse_leans_ = {Pair{leans_[1][1] / determinant, -leans_[0][1] / determinant},
                      Pair{-leans_[1][0] / determinant, leans_[0][0] / determinant}};
}

// The start: the middle of X and its foot point on Y, by a few steps of Newton's method, or the nearest
// places that are at most `beside` outside their parts. False: the parts are not over each other.
bool CrossShear::set_start(const CrossCell &x, const CrossCell &y, double beside) {
    constexpr int most_steps = 4;
    constexpr double far = 4, near = 0x1p-16, nearly = 0x1p-5;
    starts_ = {Pair{0.5, 0.5}, Pair{0.5, 0.5}};
    CrossPiece::Point of_x{x.centre(), {}, {}}, of_y{y.centre(), {}, {}};
    slopes_of_x_ = {x.slope(0), x.slope(1)};
    slopes_of_y_ = {y.slope(0), y.slope(1)};
    for (int i = 0;; ++i) {
        between_ = of_x.at - of_y.at;
        if (!set_vectors(slopes_of_y_[0], slopes_of_y_[1])) {
            return false;
        }
        set_leans();
        const Pair step{dot(vectors_[0], between_), dot(vectors_[1], between_)};
        const double size = std::max(std::abs(step[0]), std::abs(step[1]));
        if (size <= near || i == most_steps || !(size <= far)) {
            const bool is_above = std::abs(dot(vectors_[2], between_)) >= length(between_) / 2;
            return size <= near || (size <= nearly && is_above);
        }
        if (move_foot(step, beside)) {
            of_x = x.piece().evaluate(x.in_piece(starts_[0].data()));
            slopes_of_x_ = slopes_of(x, of_x);
        }
        of_y = y.piece().evaluate(y.in_piece(starts_[1].data()));
        slopes_of_y_ = slopes_of(y, of_y);
    }
}

// Whether a plane perpendicular to the segment between the places where the parts are nearest separates them.
bool CrossShear::are_beside(const CrossCell &x, const CrossCell &y) const {
    const double size = length(between_);
    if (!(size > 0)) {
        return false;
    }
    const Vector3 unit = (1 / size) * between_;
    count_work(100);
    return x.hull_along(unit).lower - y.hull_along(unit).upper > 4 * (x.error() + y.error());
}

// Moves the foot by a step, to at most `beside` outside Y, and makes up for what is cut off by moving the
// place in X. Returns whether that place was moved.
bool CrossShear::move_foot(const Pair &step, double beside) noexcept {
    auto &[at, foot] = starts_;
    Pair beyond{};
    for (size_t i = 0; i < 2; ++i) {
        const double next = foot[i] + step[i];
        foot[i] = std::clamp(next, -beside, 1 + beside);
        beyond[i] = next - foot[i];
    }
    if (beyond == Pair{0, 0} || !has_inverse_) {
        return false;
    }
    for (size_t j = 0; j < 2; ++j) {
        at[j] = std::clamp(at[j] - inverse_leans_[j][0] * beyond[0] - inverse_leans_[j][1] * beyond[1],
                           -beside, 1 + beside);
    }
    return true;
}

// Whether the parts are one surface rather than two, judged by the start and the tangent planes there.
// Surfaces that cross at a small angle are within the tolerance long before their parts are flat, but they
// come apart by a good part of it.
bool CrossShear::is_along(double tolerance) const noexcept {
    constexpr double hardly = 0x1p-4; // relative to the tolerance
    return std::abs(dot(vectors_[2], between_)) + std::abs(dot(vectors_[2], slopes_of_x_[0])) +
               std::abs(dot(vectors_[2], slopes_of_x_[1])) <=
           hardly * tolerance;
}

CrossShear::Verdict CrossShear::set(const CrossCell &x, const CrossCell &y, double tolerance) {
    count_work(600);
    if (!set_start(x, y, 0)) {
        if (are_beside(x, y)) {
            return Verdict::apart;
        }
        // Parts beside each other may have curved sides that no plane separates: bounds from a start over
        // both, a little outside, may show that they are apart.
        if (!set_start(x, y, widening)) {
            return Verdict::open;
        }
    }
    if (is_along(tolerance)) {
        return Verdict::open;
    }
    count_work(600);
    set_errors(x, y);
    set_bends(2, x, y);
    if (!is_useful()) {
        return Verdict::useless;
    }
    count_work(800);
    set_bends(0, x, y);
    set_bends(1, x, y);
    constexpr double most = 2;
    grows_ = 0;
    Away wide{wide_ranges(starts_[0]), wide_ranges(starts_[1]), {infinity, infinity}};
    if (!set_aside(wide) || !(std::max(wide.aside[0], wide.aside[1]) <= most)) {
        return Verdict::open;
    }
    Away box{box_ranges(x, starts_[0]), box_ranges(y, starts_[1]), wide.aside};
    if (!narrow(box)) {
        return Verdict::apart;
    }
    set_aside(box);
    set_zeros(box);
    if (parts_ == 0) {
        return Verdict::apart;
    }
    set_ranges(box);
    if (!give_room(wide)) {
        return Verdict::apart;
    }
    set_slopes(wide);
    set_cut(x, y, wide);
    return Verdict::bounded;
}

} // namespace nrb::intersect
