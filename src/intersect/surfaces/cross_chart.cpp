// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_chart.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// A determinant below this, relative to the product of the lengths of its columns, counts as 0.
constexpr double least_determinant = 1e-11;
// The largest norm of R, and the largest diagonal entry of (I - R)^-1, that make a chart: beyond these D is
// so wide that nothing follows from it.
constexpr double most_rho = 0.6, most_coupling = 2.5;
// The largest noise of M F, in lengths of the parts, at which a chart can still tell places apart.
constexpr double least_digits = 0x1p-4;

std::array<size_t, 3> others_of(size_t k) noexcept {
    return {k == 0 ? size_t{1} : 0, k <= 1 ? size_t{2} : 1, k <= 2 ? size_t{3} : 2};
}

Interval negative(const Interval &x) noexcept {
    return {-x.upper, -x.lower};
}

} // namespace

CrossPlace common_direction(const std::array<Vector3, 2> &a, const std::array<Vector3, 2> &b) noexcept {
    const Vector3 of_a = cross(a[0], a[1]), of_b = cross(b[0], b[1]);
    return {dot(a[1], of_b), -dot(a[0], of_b), -dot(b[1], of_a), dot(b[0], of_a)};
}

bool solve_columns(const std::array<Vector3, 4> &columns, size_t fixed, const Vector3 &of,
                   CrossPlace &solution) noexcept {
    const auto [i, j, k] = others_of(fixed);
    const Vector3 &a = columns[i], &b = columns[j], &c = columns[k], across = cross(b, c);
    const double determinant = dot(a, across);
    if (!(std::abs(determinant) > 0x1p-50 * length(a) * length(b) * length(c))) {
        return false;
    }
    solution[fixed] = 0;
    solution[i] = dot(of, across) / determinant;
    solution[j] = dot(of, cross(c, a)) / determinant;
    solution[k] = dot(of, cross(a, b)) / determinant;
    return true;
}

bool CrossChart::set_rows(const CrossCell &a, const CrossCell &b) {
    const std::array<Vector3, 4> columns{a.slope(0), a.slope(1), -1 * b.slope(0), -1 * b.slope(1)};
    const CrossPlace direction = common_direction({a.slope(0), a.slope(1)}, {b.slope(0), b.slope(1)});
    axis_ = 0;
    for (size_t i = 1; i < 4; ++i) {
        axis_ = std::abs(direction[i]) > std::abs(direction[axis_]) ? i : axis_;
    }
    direction_ = direction[axis_] > 0 ? 1 : -1;
    const auto [i, j, k] = others_of(axis_);
    const Vector3 &x = columns[i], &y = columns[j], &z = columns[k], across = cross(y, z);
    const double determinant = dot(x, across);
    if (!(std::abs(determinant) > least_determinant * length(x) * length(y) * length(z))) {
        return false;
    }
    const double inverse = 1 / determinant;
    rows_[axis_] = {};
    rows_[i] = inverse * across;
    rows_[j] = inverse * cross(z, x);
    rows_[k] = inverse * cross(x, y);
    set_norms();
    own_norms_ = norms_;
    return std::isfinite(most_norm_);
}

void CrossChart::set_norms() noexcept {
    most_norm_ = 0;
    for (size_t r = 0; r < 4; ++r) {
        norms_[r] = 1.0001 * length(rows_[r]);
        most_norm_ = std::max(most_norm_, norms_[r]);
    }
}

// Bounds row i of M F, M F'_k and I - M F' over the wide parts. False: row i of M F is nowhere 0.
bool CrossChart::set_row(size_t i, const CrossCell &a, const CrossCell &b) {
    const CrossExtents of_a = a.along(rows_[i]), of_b = b.along(rows_[i]);
    const double middle = dot(rows_[i], a.centre() - b.centre()),
                 room = norms_[i] * (a.wide_error() + b.wide_error()) + 8 * eps * std::abs(middle);
    if (middle + of_a.points.lower - of_b.points.upper > room ||
        middle + of_a.points.upper - of_b.points.lower < -room) {
        return false;
    }
    const std::array<Interval, 4> columns{of_a.slopes[0], of_a.slopes[1], negative(of_b.slopes[0]),
                                          negative(of_b.slopes[1])};
    std::array<double, 2> off{};
    for (size_t k = 0; k < 4; ++k) {
        if (k != axis_) {
            const double wanted = k == i ? 1 : 0;
            const double own = magnitude_of({columns[k].lower - wanted, columns[k].upper - wanted});
            coupling_.set_off(i, k, 1.0001 * own + 16 * eps);
            off[k / 2] += own;
        }
    }
    shifts_[i] = columns[axis_];
    off[axis_ / 2] += (shifts_[i].upper - shifts_[i].lower) / 2;
    for (size_t s = 0; s < 2; ++s) {
        bends_[s] = std::max(bends_[s], off[s]);
    }
    return true;
}

CrossChart::Verdict CrossChart::set(CrossCell &a, CrossCell &b) {
    near_ = 1.01 * (a.amplified() * a.piece().error + b.amplified() * b.piece().error);
    count_work(400);
    sheared_ = false;
    start_.fill(0.5);
    ranges_.fill({-infinity, infinity});
    leans_ = leans_along_ = aside_ = {};
    most_difference_ = infinity;
    has_rows_ = set_rows(a, b);
    if (!has_rows_) {
        return Verdict::flat;
    }
    bends_ = {};
    coupling_.clear();
    for (const size_t i : others_of(axis_)) {
        count_work(800);
        if (!set_row(i, a, b)) {
            return Verdict::apart;
        }
    }
    shifts_[axis_] = {-1, -1};
    coupled_ = coupling_.norm() <= most_rho;
    if (!coupled_ || !(most_norm_ * near_ < least_digits)) {
        return Verdict::bent;
    }
    own_shifts_ = shifts_;
    set_rises();
    return Verdict::chart;
}

void CrossChart::set_rises() noexcept {
    CrossPlace fastest{};
    for (const size_t i : others_of(axis_)) {
        fastest[i] = magnitude_of(own_shifts_[i]);
    }
    const CrossPlace room = from_own(coupling_.drift(reach_of(fastest)));
    for (size_t i = 0; i < 4; ++i) {
        rises_[i] = {-shifts_[i].upper - room[i], -shifts_[i].lower + room[i]};
    }
}

// Whether the bounds are of use to find the arc: each coordinate of all zeros is known to stay inside the
// parts, or its D is so narrow that one known zero tells where the others are.
bool CrossChart::has_narrow_rises() const noexcept {
    constexpr double widest = 2;
    for (size_t i = 0; i < 4; ++i) {
        const bool inside = ranges_[i].lower > 0 && ranges_[i].upper < 1;
        if (!inside && !(width_of(rises_[i]) <= widest)) {
            return false;
        }
    }
    return true;
}

CrossPlace CrossChart::drift(const CrossPlace &step, double off, double far,
                             const CrossPlace &farthest) const noexcept {
    CrossPlace size{};
    for (const size_t i : others_of(axis_)) {
        size[i] =
            std::abs(of_own(i, step)) + off * own_norms_[i] * near_ + magnitude_of(own_shifts_[i]) * far;
    }
    CrossPlace reach = reach_of(size);
    for (size_t i = 0; i < 4; ++i) {
        const double most =
            sheared_ ? farthest[i] + std::abs(leans_[i]) * farthest[across_] + std::abs(leans_along_[i]) * far
                     : largest(farthest);
        reach[i] = std::min(reach[i], most);
    }
    return from_own(coupling_.drift(reach));
}

// Without a shear, all coordinates have about the same scale, and the maximum norm is good enough; in a shear
// they have not, and bounds are taken row by row.
CrossPlace CrossChart::reach_of(const CrossPlace &size) const noexcept {
    return sheared_ ? coupling_.reach(size) : coupling_.reach_in_norm(size);
}

// Bounds of the coordinates y from those of x_j and sigma, at one x_k.
CrossPlace CrossChart::from_own(CrossPlace bounds) const noexcept {
    for (size_t i = 0; i < 4; ++i) {
        bounds[i] += leans_[i] == 0 ? 0 : 1.0001 * std::abs(leans_[i]) * bounds[across_];
    }
    return bounds;
}

bool CrossChart::holds_at(const CrossPlace &z) const noexcept {
    const auto away = [&](size_t i) { return z[i] - start_[i]; };
    for (size_t i = 0; i < 4 && sheared_; ++i) {
        if (i / 2 != axis_ / 2 &&
            !(std::abs(away(i) - leans_[i] * away(across_) - leans_along_[i] * away(axis_)) <= aside_[i])) {
            return false;
        }
    }
    return true;
}

CrossPlace CrossChart::off_at(double difference) const noexcept {
    CrossPlace size{};
    for (const size_t i : others_of(axis_)) {
        size[i] = difference <= most_difference_ ? own_norms_[i] * difference : infinity;
    }
    const CrossPlace drift = coupling_.drift(reach_of(size));
    for (size_t i = 0; i < 4; ++i) {
        size[i] = 1.0001 * (size[i] + drift[i]);
    }
    return from_own(size);
}

// Adds to row i of R what the columns of one surface contribute. factors: make the derivatives of the cell
// those by places in the part of the chart.
void CrossChart::add_offs(size_t i, size_t surface, const CrossCell &cell,
                          const std::array<double, 2> &factors, Coupling<4> &coupling) const noexcept {
    const CrossExtents extents = cell.along(rows_[i]);
    for (size_t k = 0; k < 2; ++k) {
        const size_t column = 2 * surface + k;
        const double sign = surface == 0 ? factors[k] : -factors[k], wanted = column == i ? 1 : 0;
        if (column != axis_) {
            const double own = std::max(std::abs(sign * extents.slopes[k].lower - wanted),
                                        std::abs(sign * extents.slopes[k].upper - wanted));
            coupling.set_off(i, column, std::max(coupling.off(i, column), 1.0001 * own + 16 * eps));
        }
    }
}

bool CrossChart::goes_on(const CrossCell &a, const CrossCell &b, std::span<const CrossCell::Beyond> beyond_a,
                         std::span<const CrossCell::Beyond> beyond_b) const {
    constexpr double most = 0.9;
    if (sheared_) {
        return false;
    }
    Coupling<4> coupling;
    for (const size_t i : others_of(axis_)) {
        const auto add = [&](size_t surface, const CrossCell &own,
                             std::span<const CrossCell::Beyond> beyond) {
            add_offs(i, surface, own, {1, 1}, coupling);
            for (const CrossCell::Beyond &part : beyond) {
                std::array<double, 2> factors{1, 1};
                factors[part.axis] = part.factor;
                add_offs(i, surface, part.cell, factors, coupling);
            }
        };
        count_work(800);
        add(0, a, beyond_a);
        add(1, b, beyond_b);
    }
    return coupling.norm() <= most;
}

// Of both x, k is the one along which n . G changes less.
void CrossChart::set_lean(const CrossShear &shear, size_t base) {
    const auto middle = [&](size_t j) { return shear.slope(j).lower / 2 + shear.slope(j).upper / 2; };
    const size_t j = std::abs(middle(0)) >= std::abs(middle(1)) ? 0 : 1, other = 2 - base;
    across_ = base + j;
    axis_ = base + 1 - j;
    const double slope = middle(j), sign = base == 0 ? 1 : -1; // F = +-G
    leans_ = leans_along_ = aside_ = {};
    rows_[axis_] = {};
    rows_[across_] = (sign / slope) * shear.normal();
    own_norms_[axis_] = 0;
    own_norms_[across_] = 1.0001 / std::abs(slope);
    own_shifts_[across_] = (1 / slope) * shear.slope(1 - j);
    most_difference_ = infinity;
    for (size_t m = 0; m < 2; ++m) {
        const size_t i = other + m;
        leans_[i] = shear.lean(m, j);
        leans_along_[i] = shear.lean(m, 1 - j);
        aside_[i] = shear.most_aside(m);
        rows_[i] = leans_[i] * rows_[across_] - sign * shear.dual(m);
        own_norms_[i] = 1.0001 * length(shear.dual(m));
        own_shifts_[i] = -1 * shear.along(m, 1 - j);
        most_difference_ = std::min(most_difference_, shear.free() / own_norms_[i]);
        start_[base + m] = shear.start_x()[m];
        start_[i] = shear.start_y()[m];
        ranges_[base + m] = shear.range_of_x(m);
        ranges_[i] = shear.range_of_y(m);
    }
    const auto &of_a = base == 0 ? shear.slopes_of_x() : shear.slopes_of_y();
    const auto &of_b = base == 0 ? shear.slopes_of_y() : shear.slopes_of_x();
    direction_ = common_direction(of_a, of_b)[axis_] > 0 ? 1 : -1;
    set_norms();
}

void CrossChart::couple(const CrossShear &shear) {
    const size_t base = across_ / 2 * 2, other = 2 - base, j = across_ - base;
    const auto bound = [](const Interval &x) { return 1.0001 * magnitude_of(x) + 16 * eps; };
    const double slope = shear.slope(j).lower / 2 + shear.slope(j).upper / 2;
    coupling_.clear();
    coupling_.set_off(across_, across_, bound((1 / slope) * shear.slope(j) - Interval{1, 1}));
    for (size_t m = 0; m < 2; ++m) {
        coupling_.set_off(across_, other + m, bound((1 / slope) * shear.tilt(m)));
        coupling_.set_off(other + m, across_, bound(shear.along(m, j)));
        for (size_t i = 0; i < 2; ++i) {
            const double wanted = i == m ? 1 : 0;
            coupling_.set_off(other + m, other + i, bound(shear.own(m, i) - Interval{wanted, wanted}));
        }
    }
}

CrossChart::Verdict CrossChart::set_sheared(size_t base, const CrossShear &shear) {
    sheared_ = true;
    set_lean(shear, 2 * base);
    couple(shear);
    coupled_ = coupling_.invert(most_coupling);
    if (!std::isfinite(most_norm_) || !coupled_ || !(most_norm_ * near_ < least_digits)) {
        return Verdict::bent;
    }
    for (size_t i = 0; i < 4; ++i) {
        const double along = leans_along_[i];
        shifts_[i] = i == across_
                         ? own_shifts_[i]
                         : own_shifts_[i] + leans_[i] * own_shifts_[across_] - Interval{along, along};
    }
    own_shifts_[axis_] = shifts_[axis_] = {-1, -1};
    set_rises();
    return has_narrow_rises() ? Verdict::chart : Verdict::bent;
}

CrossPlace CrossChart::step(const Vector3 &difference) const noexcept {
    CrossPlace result{};
    for (size_t i = 0; i < 4; ++i) {
        result[i] = dot(rows_[i], difference);
    }
    return result;
}

} // namespace nrb::intersect
