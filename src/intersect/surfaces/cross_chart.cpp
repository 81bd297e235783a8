// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_chart.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// A determinant that is smaller than this, in parts of the lengths of its columns, is none.
constexpr double least_determinant = 1e-11;
// What is above leaves directions so wide that nothing follows from them.
constexpr double most_rho = 0.6;
// Of the places that a chart has to tell apart.
constexpr double least_digits = 0x1p-4;

std::array<size_t, 3> others_of(size_t k) noexcept {
    return {k == 0 ? size_t{1} : 0, k <= 1 ? size_t{2} : 1, k <= 2 ? size_t{3} : 2};
}

Interval negative(const Interval &x) noexcept {
    return {-x.upper, -x.lower};
}

double largest_of(const Interval &x) noexcept {
    return std::max(std::abs(x.lower), std::abs(x.upper));
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
    most_norm_ = 0;
    for (size_t r = 0; r < 4; ++r) {
        norms_[r] = 1.0001 * length(rows_[r]);
        most_norm_ = std::max(most_norm_, norms_[r]);
    }
    return std::isfinite(most_norm_);
}

// Row i of M F, M F'_k and I - M F'; false: M F is nowhere 0.
bool CrossChart::set_row(size_t i, const CrossCell &a, const CrossCell &b) {
    const CrossExtents of_a = a.along(rows_[i]), of_b = b.along(rows_[i]);
    const double middle = dot(rows_[i], a.centre() - b.centre()),
                 room = 2 * norms_[i] * (a.error() + b.error()) + 8 * eps * std::abs(middle);
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
            off[k / 2] += largest_of({columns[k].lower - wanted, columns[k].upper - wanted});
        }
    }
    shifts_[i] = columns[axis_];
    rho_[i] = 1.0001 * (off[0] + off[1]) + 32 * eps;
    off[axis_ / 2] += (shifts_[i].upper - shifts_[i].lower) / 2;
    for (size_t s = 0; s < 2; ++s) {
        bends_[s] = std::max(bends_[s], off[s]);
    }
    return true;
}

CrossChart::Verdict CrossChart::set(CrossCell &a, CrossCell &b) {
    near_ = 1.01 * (a.piece().error + b.piece().error);
    count_work(400);
    has_rows_ = set_rows(a, b);
    if (!has_rows_) {
        return Verdict::flat;
    }
    bends_ = {};
    most_rho_ = 0;
    for (const size_t i : others_of(axis_)) {
        count_work(800);
        if (!set_row(i, a, b)) {
            return Verdict::apart;
        }
        most_rho_ = std::max(most_rho_, rho_[i]);
    }
    shifts_[axis_] = {-1, -1};
    rho_[axis_] = 0;
    if (!(most_rho_ <= most_rho) || !(most_norm_ * near_ < least_digits)) {
        return Verdict::bent;
    }
    set_rises();
    return Verdict::chart;
}

void CrossChart::set_rises() noexcept {
    double fastest = 0;
    for (size_t i = 0; i < 4; ++i) {
        fastest = i == axis_ ? fastest : std::max(fastest, largest_of(shifts_[i]));
    }
    for (size_t i = 0; i < 4; ++i) {
        const double room = i == axis_ ? 0 : 1.0001 * rho_[i] * fastest / (1 - most_rho_);
        rises_[i] = {-shifts_[i].upper - room, -shifts_[i].lower + room};
    }
}

// What the columns of one surface add to rho_i.
double CrossChart::off(size_t i, size_t surface, const CrossCell &cell,
                       const std::array<double, 2> &factors) const noexcept {
    const CrossExtents extents = cell.along(rows_[i]);
    double sum = 0;
    for (size_t k = 0; k < 2; ++k) {
        const size_t column = 2 * surface + k;
        const double sign = surface == 0 ? factors[k] : -factors[k], wanted = column == i ? 1 : 0;
        if (column != axis_) {
            sum += std::max(std::abs(sign * extents.slopes[k].lower - wanted),
                            std::abs(sign * extents.slopes[k].upper - wanted));
        }
    }
    return 1.0001 * sum + 16 * eps;
}

bool CrossChart::goes_on(const CrossCell &a, const CrossCell &b, std::span<const CrossCell::Beyond> beyond_a,
                         std::span<const CrossCell::Beyond> beyond_b) const noexcept {
    constexpr double most = 0.9;
    for (const size_t i : others_of(axis_)) {
        const auto largest = [&](size_t surface, const CrossCell &own,
                                 std::span<const CrossCell::Beyond> beyond) {
            double result = off(i, surface, own, {1, 1});
            for (const CrossCell::Beyond &part : beyond) {
                std::array<double, 2> factors{1, 1};
                factors[part.axis] = part.factor;
                result = std::max(result, off(i, surface, part.cell, factors));
            }
            return result;
        };
        count_work(800);
        if (!(largest(0, a, beyond_a) + largest(1, b, beyond_b) <= most)) {
            return false;
        }
    }
    return true;
}

CrossPlace CrossChart::step(const Vector3 &difference) const noexcept {
    CrossPlace result{};
    for (size_t i = 0; i < 4; ++i) {
        result[i] = dot(rows_[i], difference);
    }
    return result;
}

} // namespace nrb::intersect
