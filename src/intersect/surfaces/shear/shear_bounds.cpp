// SPDX-License-Identifier: MIT
#include "intersect/surfaces/shear/cross_shear.h"

#include "base/numbers.h"
#include "intersect/intervals.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr double least_aside = 0x1p-20; // room for the rounding of zeros, in lengths of parts

} // namespace

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

// Whether, along an axis of X along which the surfaces bend by more than a little, they may bend alike: H is
// not known to exceed a quarter of what both bend.
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

void CrossShear::set_errors(const CrossCell &x, const CrossCell &y) noexcept {
    error_ = 1.01 * (x.amplified() * x.error() + y.amplified() * y.error()) + 4 * eps * length(between_);
    for (size_t j = 0; j < 2; ++j) {
        own_errors_[j] = 1.01 * y.slope_error(j) + 16 * eps * length(slopes_of_y_[j]);
    }
    for (size_t j = 0; j < 2; ++j) {
        slope_errors_[j] = 1.01 * x.slope_error(j) + 16 * eps * length(slopes_of_x_[j]) +
                           std::abs(leans_[0][j]) * own_errors_[0] + std::abs(leans_[1][j]) * own_errors_[1];
    }
}

// Bounds d . C_j in a region. share: how much of the changes from the start counts; 1 for all places of the
// region, 1/2 for the mean over the segment from the start to any of them. While nothing is known of sigma,
// the changes of both surfaces are bounded separately.
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

// Bounds |sigma| at the zeros of a region. With the means of N . C and N . Y' over the segment from the
// start, a zero has
//     0 = N . G = N . G(x_0, y_0) + (N . C) (x - x_0) - (N . Y') sigma.
// False: Y bends too much for N . Y' to be certainly invertible.
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

// Narrows x - x_0 to L^-1 (y - y_0 - sigma), and y - y_0 to L (x - x_0) + sigma. False: nothing is left.
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

// Sets the region in which the bounds are to hold: |sigma| at most twice its bound at zeros. That bound is
// first the one over the wide parts, then the one over what twice the first bound leaves of them. False:
// nothing is left.
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

void CrossShear::set_slopes(const Away &away) noexcept {
    for (size_t d = 0; d < 3; ++d) {
        for (size_t j = 0; j < 2; ++j) {
            slopes_[d][j] = slope_in(d, j, away, 1);
            owns_[d][j] = own_in(d, j, away, 1);
        }
    }
}

} // namespace nrb::intersect
