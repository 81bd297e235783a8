// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_shear.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr double least_aside = 0x1p-20; // what zeros may be off for rounding, in parts

// Of both axes, as differences from a place: of the wide part, or where what is beside borders is told, too.
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

// The least value of h x + c x^2 / 2.
double least_of(double h, double c, const Interval &x) noexcept {
    const auto at = [&](double place) { return place * (h + c / 2 * place); };
    double least = std::min(at(x.lower), at(x.upper));
    if (c > 0 && -h > c * x.lower && -h < c * x.upper) {
        least = std::min(least, -h * h / (2 * c));
    }
    return least;
}

// c + h x + b x^2 / 2.
struct Parabola {
    double c, h, b;

    [[nodiscard]] double at(double x) const noexcept { return c + x * (h + b / 2 * x); }
    // Infinite: there is none.
    [[nodiscard]] std::array<double, 2> zeros() const noexcept {
        const double discriminant = h * h - 2 * b * c;
        if (!(discriminant >= 0)) {
            return {infinity, infinity};
        }
        const double q = -(h + std::copysign(std::sqrt(discriminant), h));
        return {q / b, 2 * c / q};
    }
};

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

// The middle of X and its foot on Y, or what is nearest to these in both parts, by a few steps of Newton's method. False: both are not
// over each other.
bool CrossShear::set_start(const CrossCell &x, const CrossCell &y) {
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
        if (move_foot(step)) {
            of_x = x.piece().evaluate(x.in_piece(starts_[0].data()));
            slopes_of_x_ = slopes_of(x, of_x);
        }
        of_y = y.piece().evaluate(y.in_piece(starts_[1].data()));
        slopes_of_y_ = slopes_of(y, of_y);
    }
}

// Whether a plane across the way from one to the other, where they come nearest, is between them.
bool CrossShear::are_beside(const CrossCell &x, const CrossCell &y) const noexcept {
    const double size = length(between_);
    if (!(size > 0)) {
        return false;
    }
    const Vector3 unit = (1 / size) * between_;
    count_work(100);
    return x.hull_along(unit).lower - y.hull_along(unit).upper > 4 * (x.error() + y.error());
}

// What would be beyond Y is made up for in X. Whether that moves.
bool CrossShear::move_foot(const Pair &step) noexcept {
    auto &[at, foot] = starts_;
    Pair beyond{};
    for (size_t i = 0; i < 2; ++i) {
        const double next = foot[i] + step[i];
        foot[i] = std::clamp(next, 0.0, 1.0);
        beyond[i] = next - foot[i];
    }
    if (beyond == Pair{0, 0} || !has_inverse_) {
        return false;
    }
    for (size_t j = 0; j < 2; ++j) {
        at[j] =
            std::clamp(at[j] - inverse_leans_[j][0] * beyond[0] - inverse_leans_[j][1] * beyond[1], 0.0, 1.0);
    }
    return true;
}

// As far as the start and the planes of tangents there tell: one surface rather than two.
bool CrossShear::is_along(double tolerance) const noexcept {
    return std::abs(dot(vectors_[2], between_)) + std::abs(dot(vectors_[2], slopes_of_x_[0])) +
               std::abs(dot(vectors_[2], slopes_of_x_[1])) <=
           tolerance;
}

void CrossShear::set_bends(size_t d, const CrossCell &x, const CrossCell &y) {
    Bends &bends = bends_[d];
    bends.of_x = x.seconds_along(vectors_[d]);
    bends.of_y = y.seconds_along(vectors_[d]);
    const auto &[first, second] = leans_;
    for (size_t e = 0; e < 3; ++e) {
        const size_t j = e == 2 ? 1 : 0, l = e == 0 ? 0 : 1;
        bends.leaning[e] = (first[j] * first[l]) * bends.of_y[0] +
                           (first[j] * second[l] + second[j] * first[l]) * bends.of_y[1] +
                           (second[j] * second[l]) * bends.of_y[2];
        bends.both[e] = bends.of_x[e] - bends.leaning[e];
    }
    for (size_t j = 0; j < 2; ++j) {
        for (size_t m = 0; m < 2; ++m) {
            bends.mixed[j][m] = first[j] * bends.of_y[m] + second[j] * bends.of_y[1 + m];
        }
    }
}

// Along an axis along which they bend by more than a little.
bool CrossShear::is_useful() const noexcept {
    constexpr double much = 4, little = 0x1p-20;
    const Bends &bends = bends_[2];
    const auto own = [&](size_t d) { return magnitude_of(bends.of_x[d]) + magnitude_of(bends.leaning[d]); };
    const double most = std::max({own(0), own(1), own(2)});
    for (const size_t d : {size_t{0}, size_t{2}}) {
        const Interval &both = bends.both[d];
        const bool apart = much * both.lower > own(d) || much * both.upper < -own(d);
        if (own(d) > little * most && !apart) {
            return true;
        }
    }
    return false;
}

// Whether both come apart, for certain or on both sides of a place.
bool CrossShear::come_apart() const noexcept {
    const Interval &slope = slopes_[2][across_];
    return parts_ == 2 || slope.lower > 0 || slope.upper < 0;
}

void CrossShear::set_errors(const CrossCell &x, const CrossCell &y) noexcept {
    error_ = 1.01 * (x.error() + y.error()) + 4 * eps * length(between_);
    for (size_t j = 0; j < 2; ++j) {
        own_errors_[j] = 1.01 * y.slope_error(j) + 16 * eps * length(slopes_of_y_[j]);
    }
    for (size_t j = 0; j < 2; ++j) {
        slope_errors_[j] = 1.01 * x.slope_error(j) + 16 * eps * length(slopes_of_x_[j]) +
                           std::abs(leans_[0][j]) * own_errors_[0] + std::abs(leans_[1][j]) * own_errors_[1];
    }
}

// d . C_j; share: of the differences, 1/2 for the mean of all places between the start and another one. Where nothing is known of
// sigma, that of both surfaces by itself.
Interval CrossShear::slope_in(size_t d, size_t j, const Away &away, double share) const noexcept {
    const Bends &bends = bends_[d];
    const bool known = std::isfinite(away.aside[0]);
    const std::array<Interval, 3> &second = known ? bends.both : bends.of_x;
    const Ranges off = known ? Ranges{around(away.aside[0]), around(away.aside[1])} : away.y;
    const Interval change = second[j] * away.x[0] + second[j + 1] * away.x[1] - bends.mixed[j][0] * off[0] -
                            bends.mixed[j][1] * off[1];
    const double start = d == 2 ? dot(vectors_[2], slopes_of_x_[j]) : 0;
    return Interval{start, start} + share * change +
           around(lengths_[d] * slope_errors_[j] + 8 * eps * magnitude_of(change));
}

Interval CrossShear::own_in(size_t d, size_t m, const Away &away, double share) const noexcept {
    const std::array<Interval, 3> &bends = bends_[d].of_y;
    const Interval change = bends[m] * away.y[0] + bends[m + 1] * away.y[1];
    const double start = d == m ? 1 : 0;
    return Interval{start, start} + share * change +
           around(lengths_[d] * own_errors_[m] + 8 * eps * magnitude_of(change));
}

// N . G = 0 is N . G at the start, and N . C times the way there, less N . Y' sigma. False: Y bends too much for N . Y' to have a certain
// inverse.
bool CrossShear::set_aside(Away &away) {
    constexpr double least = 0.3;
    std::array<Pair, 2> offs{};
    Pair size{};
    for (size_t i = 0; i < 2; ++i) {
        size[i] = std::abs(dot(vectors_[i], between_)) + lengths_[i] * error_;
        for (size_t j = 0; j < 2; ++j) {
            const double wanted = i == j ? 1 : 0;
            offs[i][j] = 1.0001 * magnitude_of(own_in(i, j, away, 0.5) - Interval{wanted, wanted});
            size[i] += 1.0001 * magnitude_of(slope_in(i, j, away, 0.5)) * magnitude_of(away.x[j]);
        }
    }
    const double a = 1 - offs[0][0], d = 1 - offs[1][1], determinant = a * d - offs[0][1] * offs[1][0];
    if (!(a > least && d > least && determinant > least)) {
        return false;
    }
    const Pair aside{1.0001 * (d * size[0] + offs[0][1] * size[1]) / determinant,
                     1.0001 * (offs[1][0] * size[0] + a * size[1]) / determinant};
    away.aside = {std::min(away.aside[0], aside[0]), std::min(away.aside[1], aside[1])};
    grows_ = std::max({grows_, 1.01 * (d + offs[0][1]) / determinant, 1.01 * (offs[1][0] + a) / determinant});
    return true;
}

// x - x_0 = L^-1 (y - y_0 - sigma), and the other way round; false: nothing is left.
bool CrossShear::narrow(Away &away) const noexcept {
    constexpr double slack = 0x1p-30;
    const auto both = [](Interval &x, const Interval &y) {
        x = {std::max(x.lower, y.lower), std::min(x.upper, y.upper)};
        return x.lower <= x.upper;
    };
    for (size_t j = 0; j < 2 && has_inverse_; ++j) {
        Interval own{0, 0};
        for (size_t i = 0; i < 2; ++i) {
            own = own + inverse_leans_[j][i] * (away.y[i] + around(1.0001 * away.aside[i] + slack));
        }
        if (!both(away.x[j], own)) {
            return false;
        }
    }
    for (size_t i = 0; i < 2; ++i) {
        const Interval own = leans_[i][0] * away.x[0] + leans_[i][1] * away.x[1];
        if (!both(away.y[i], own + around(1.0001 * away.aside[i] + slack * (1 + magnitude_of(own))))) {
            return false;
        }
    }
    return true;
}

// Between which numbers n . G is, less n . C_j(x_0, y_0) (x - x_0)_j + H_jj (x - x_0)_j^2 / 2.
Interval CrossShear::height_beside(size_t j, const Away &away) const noexcept {
    const Bends &bends = bends_[2];
    const size_t k = 1 - j;
    const double middle = dot(vectors_[2], between_), h = dot(vectors_[2], slopes_of_x_[k]);
    double room = 2 * error_;
    for (size_t i = 0; i < 2; ++i) {
        const double far = magnitude_of(away.x[i]);
        room += 1.001 * (slope_errors_[i] * far + own_errors_[i] * away.aside[i]);
        for (size_t m = 0; m < 2; ++m) {
            room += 1.001 * magnitude_of(bends.mixed[i][m]) * far * away.aside[m] +
                    0.501 * magnitude_of(bends.of_y[i + m]) * away.aside[i] * away.aside[m];
        }
    }
    const Interval both = bends.both[1] * (away.x[0] * away.x[1]);
    return {middle + both.lower + least_of(h, bends.both[2 * k].lower, away.x[k]) - room,
            middle + both.upper - least_of(-h, -bends.both[2 * k].upper, away.x[k]) + room};
}

// Along the axis along which n . C changes more: where both bounds of n . G, which are polynomials of degree 2, leave 0 between them.
void CrossShear::set_zeros(const Away &away) noexcept {
    const Bends &bends = bends_[2];
    const auto change = [&](size_t j) {
        const double far = magnitude_of(away.x[j]);
        return magnitude_of(bends.both[2 * j]) * far * far;
    };
    across_ = change(1) > change(0) ? 1 : 0;
    const Interval beside = height_beside(across_, away), &bend = bends.both[2 * across_],
                   &range = away.x[across_];
    height_ = magnitude_of(beside);
    const double h = dot(vectors_[2], slopes_of_x_[across_]);
    const Parabola low{beside.lower, h, bend.lower}, high{beside.upper, h, bend.upper};
    std::array<double, 6> ends{range.lower, range.upper};
    size_t count = 2;
    for (const Parabola &side : {low, high}) {
        for (const double zero : side.zeros()) {
            if (zero > range.lower && zero < range.upper) {
                ends[count++] = zero;
            }
        }
    }
    std::sort(ends.begin(), ends.begin() + count);
    parts_ = 0;
    bool goes_on = false;
    for (size_t i = 0; i + 1 < count; ++i) {
        const double middle = ends[i] / 2 + ends[i + 1] / 2;
        const bool inside = low.at(middle) <= 0 && high.at(middle) >= 0;
        if (inside && (goes_on || parts_ == places_.size())) {
            places_[parts_ - 1].upper = ends[i + 1];
        } else if (inside) {
            places_[parts_++] = {ends[i], ends[i + 1]};
        }
        goes_on = inside;
    }
}

void CrossShear::set_ranges(const Away &away) noexcept {
    constexpr double slack = 0x1p-30;
    const auto moved = [](const Interval &range, double by) {
        return Interval{range.lower + by - slack, range.upper + by + slack};
    };
    for (size_t i = 0; i < parts_; ++i) {
        places_[i] = moved(places_[i], starts_[0][across_]);
    }
    for (size_t k = 0; k < 2; ++k) {
        ranges_of_x_[k] = moved(away.x[k], starts_[0][k]);
        ranges_of_y_[k] = moved(away.y[k], starts_[1][k]);
    }
    ranges_of_x_[across_] = {places_[0].lower, places_[parts_ - 1].upper};
}

void CrossShear::set_slopes(const Away &away) noexcept {
    for (size_t d = 0; d < 3; ++d) {
        for (size_t j = 0; j < 2; ++j) {
            slopes_[d][j] = slope_in(d, j, away, 1);
            owns_[d][j] = own_in(d, j, away, 1);
        }
    }
}

// What bends of one of both leave open is the larger part of how n . C changes, or what axes of X make of it.
void CrossShear::set_cut(const CrossCell &x, const CrossCell &y, const Away &away) noexcept {
    const Bends &bends = bends_[2];
    const Pair far{magnitude_of(away.x[0]), magnitude_of(away.x[1])};
    double open_x = 0, open_y = 0, aside = 0;
    Pair own{};
    for (size_t d = 0; d < 3; ++d) {
        const size_t j = d == 2 ? 1 : 0, l = d == 0 ? 0 : 1;
        const double times = d == 1 ? 2 : 1;
        open_x += times * width_of(bends.of_x[d]) * far[j] * far[l];
        open_y += times * width_of(bends.leaning[d]) * far[j] * far[l];
    }
    for (size_t j = 0; j < 2; ++j) {
        own[j] =
            (magnitude_of(bends.both[2 * j]) * far[j] + magnitude_of(bends.both[1]) * far[1 - j]) * far[j];
        for (size_t m = 0; m < 2; ++m) {
            aside += (magnitude_of(bends.mixed[j][m]) * most_aside_[m] +
                      magnitude_of(owns_[2][m]) * magnitude_of(slopes_[m][j])) *
                     far[j];
        }
    }
    const double all = own[0] + own[1] + aside;
    if (2 * aside > all) {
        cut_ = {x.size() >= y.size(), std::nullopt};
    } else if (2 * std::max(open_x, open_y) > all) {
        cut_ = {open_x >= open_y, std::nullopt};
    } else {
        cut_ = {true, own[1] > own[0] ? size_t{1} : 0};
    }
    const Interval &slope = slopes_[2][across_];
    const bool fine = width_of(slope) <= 0.3 * std::abs(slope.lower + slope.upper);
    if (fine && cut_.axis) {
        cut_.axis = 1 - across_;
    }
}

CrossShear::Parts CrossShear::parts() const noexcept {
    constexpr double room_across = 0.25, room = 0x1p-6, least = 0x1p-12, far_less = 0.5;
    const auto wider = [](const Interval &range, double share) {
        const double more = share * width_of(range) + least;
        return Interval{std::max(range.lower - more, 0.0), std::min(range.upper + more, 1.0)};
    };
    Parts parts;
    parts.of_y = {wider(ranges_of_y_[0], room), wider(ranges_of_y_[1], room)};
    const size_t along = 1 - across_;
    double across = 0;
    for (size_t i = 0; i < parts_; ++i) {
        const Interval own = wider(places_[i], room_across);
        if (i > 0 && parts.of_x[0][across_].upper >= own.lower) {
            across += own.upper - parts.of_x[0][across_].upper;
            parts.of_x[0][across_].upper = own.upper;
            continue;
        }
        across += width_of(own);
        parts.of_x[parts.count][across_] = own;
        parts.of_x[parts.count][along] = wider(ranges_of_x_[along], room);
        ++parts.count;
    }
    const double left =
        across * width_of(parts.of_x[0][along]) * width_of(parts.of_y[0]) * width_of(parts.of_y[1]);
    parts.count = left <= far_less ? parts.count : 0;
    return parts;
}

CrossShear::Verdict CrossShear::set(const CrossCell &x, const CrossCell &y, double tolerance) {
    count_work(600);
    if (!set_start(x, y)) {
        return are_beside(x, y) ? Verdict::apart : Verdict::open;
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

// From what sigma is at zeros to what is said of: as much again, first where nothing else is known, then in what that leaves.
bool CrossShear::give_room(Away &away) {
    const auto twice = [](const Pair &aside) {
        return Pair{2 * aside[0] + least_aside, 2 * aside[1] + least_aside};
    };
    const Pair first = away.aside;
    away.aside = twice(first);
    if (!narrow(away)) {
        return false;
    }
    set_aside(away);
    const Pair aside{std::min(first[0], away.aside[0]), std::min(first[1], away.aside[1])};
    away.aside = most_aside_ = twice(aside);
    free_ = (std::min(aside[0], aside[1]) + least_aside) / grows_;
    return true;
}

} // namespace nrb::intersect
