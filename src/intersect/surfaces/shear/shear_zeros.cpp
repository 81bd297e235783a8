// SPDX-License-Identifier: MIT
#include "intersect/surfaces/shear/cross_shear.h"

#include "base/numbers.h"
#include "intersect/intervals.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// The least value of h x + c x^2 / 2 on an interval.
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
    // Infinite, or not a number: there is none.
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

// Bounds of n . G without its terms n . C_j(x_0, y_0) (x - x_0)_j + H_jj (x - x_0)_j^2 / 2.
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

// Confines the zeros along the axis of X along which n . G changes more: they are where the lower and the
// upper bound of n . G, both quadratic polynomials, have 0 between them. That makes two intervals at most.
void CrossShear::set_zeros(const Away &away) noexcept {
    const Bends &bends = bends_[2];
    const auto change = [&](size_t j) {
        const double far = magnitude_of(away.x[j]), h = std::abs(dot(vectors_[2], slopes_of_x_[j]));
        return (h + magnitude_of(bends.both[2 * j]) * far) * far;
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

bool CrossShear::touch_nowhere() const noexcept {
    return std::ranges::any_of(slopes_[2], [](const Interval &x) { return x.lower > 0 || x.upper < 0; });
}

// Chooses what to halve by what makes up most of the change of n . C over the parts: if it is sigma, the
// larger part; if it is the widths of second derivatives, the part with the wider ones; otherwise X, along
// the axis that contributes more. Along across_, X is not halved where n . C is narrow already.
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

// Nothing is left of what is beyond the part: along borders, the places of zeros are known there, too.
CrossShear::Parts CrossShear::parts() const noexcept {
    constexpr double room_across = 0.25, room = 0x1p-6, least = 0x1p-12, far_less = 0.5;
    const auto wider = [](const Interval &range, double share) {
        const double more = share * width_of(range) + least;
        return Interval{std::clamp(range.lower - more, 0.0, 1.0), std::clamp(range.upper + more, 0.0, 1.0)};
    };
    Parts parts;
    parts.of_y = {wider(ranges_of_y_[0], room), wider(ranges_of_y_[1], room)};
    const size_t along = 1 - across_;
    double across = 0;
    for (size_t i = 0; i < parts_; ++i) {
        const Interval own = wider(places_[i], room_across);
        if (width_of(own) == 0) {
            continue;
        }
        if (parts.count > 0 && parts.of_x[0][across_].upper >= own.lower) {
            across += own.upper - parts.of_x[0][across_].upper;
            parts.of_x[0][across_].upper = own.upper;
            continue;
        }
        across += width_of(own);
        parts.of_x[parts.count][across_] = own;
        parts.of_x[parts.count][along] = wider(ranges_of_x_[along], room);
        ++parts.count;
    }
    parts.left = across * width_of(parts.of_x[0][along]) * width_of(parts.of_y[0]) * width_of(parts.of_y[1]);
    parts.count = parts.left <= far_less ? parts.count : 0;
    return parts;
}

} // namespace nrb::intersect
