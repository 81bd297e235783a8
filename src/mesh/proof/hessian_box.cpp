// SPDX-License-Identifier: MIT
#include "mesh/proof/hessian_box.h"

#include "base/scratch.h"
#include "mesh/proof/coefficient_net.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

using Ranges = CoordinateRanges;

// The products of a coefficient row with the axes, about the origin.
Four in_axes(const double *row, const Vector3 &origin, const std::array<Vector3, 3> &axes) noexcept {
    const double w = row[3];
    const Vector3 a{row[0] - w * origin.x, row[1] - w * origin.y, row[2] - w * origin.z};
    return {dot(axes[0], a), dot(axes[1], a), dot(axes[2], a), w};
}

Range constant(const Range &range) noexcept {
    return {range.middle, 0, 0, range.width() * (1 + 4 * eps)};
}

void add_constant(const Range &other, Range &range) noexcept {
    const double low = std::min(range.middle - range.radius, other.middle - other.radius),
                 high = std::max(range.middle + range.radius, other.middle + other.radius);
    range = {(low + high) / 2, 0, 0, (high - low) / 2 + 4 * eps * std::max(std::abs(low), std::abs(high))};
}

void add_constants(const Ranges &others, Ranges &ranges) noexcept {
    for (size_t c = 0; c < HessianBox::coordinates; ++c) {
        Range range = ranges[c];
        add_constant(others[c], range);
        ranges.set(c, range);
    }
}

} // namespace

Hessian Hessian::anywhere() const noexcept {
    return {constant(uu), constant(uv), constant(vv)};
}

void Hessian::add(const Hessian &constants) noexcept {
    add_constant(constants.uu, uu);
    add_constant(constants.uv, uv);
    add_constant(constants.vv, vv);
}

Hessian Hessian::in_units(double u, double v) const noexcept {
    const auto times = [](const Range &range, double factor) {
        return Range{range.middle * factor, range.u * factor, range.v * factor,
                     (range.radius + 4 * eps * range.most()) * std::abs(factor)};
    };
    return {times(uu, u * u), times(uv, u * v), times(vv, v * v)};
}

HessianBox::HessianBox(const Vector3 &origin, const std::array<Vector3, 3> &axes,
                       const std::array<const double *, 4> &corners) noexcept
    : origin_(origin), axes_(axes) {
    const Four a = in_axes(corners[0], origin, axes), b = in_axes(corners[1], origin, axes),
               c = in_axes(corners[2], origin, axes), d = in_axes(corners[3], origin, axes);
    for (size_t k = 0; k < coordinates; ++k) {
        first_[0][k] = ((b[k] - a[k]) + (c[k] - d[k])) / 2;
        first_[1][k] = ((d[k] - a[k]) + (c[k] - b[k])) / 2;
    }
    corner_weight_ = (a[3] + b[3] + c[3] + d[3]) / 4;
    for (const Four &x : {a, b, c, d}) {
        reach_ = std::max(reach_, std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]));
    }
}

// Of second derivatives: an error of a coefficient counts four times.
void HessianBox::add(int u_degree, int v_degree, const double *net, const std::array<double, 2> &factors,
                     double noise) {
    const bool whole = factors[0] == 1 && factors[1] == 1, fresh = largest_weight_ < least_weight_;
    const int m = u_degree + 1, n = v_degree + 1;
    const auto size = static_cast<size_t>(m * n) * coordinates;
    Scratch scratch(2 * size);
    CoefficientNet rows{m, n, scratch.take(size)}, second{0, 0, scratch.take(size)};
    for (size_t i = 0; i < size; i += coordinates, net += coordinates) {
        in_axes(net, origin_, axes_).store(rows.rows + i);
        least_weight_ = std::min(least_weight_, net[3]);
        largest_weight_ = std::max(largest_weight_, net[3]);
    }
    const double p = u_degree, q = v_degree, fu = factors[0], fv = factors[1];
    noise_ = std::max(noise_, noise * largest_weight_);
    const double error = 4 * noise_;
    second_differences(rows, 0, 0, second);
    const Ranges uu = ranges_of(second, p * (p - 1) * fu * fu, error, whole);
    second_differences(rows, 0, 1, second);
    const Ranges uv = ranges_of(second, p * q * fu * fv, error, whole);
    second_differences(rows, 1, 1, second);
    const Ranges vv = ranges_of(second, q * (q - 1) * fv * fv, error, whole);
    if (fresh) {
        uu_ = uu;
        uv_ = uv;
        vv_ = vv;
        by_coefficients_ = is_coarse();
    } else {
        add_constants(uu, uu_);
        add_constants(uv, uv_);
        add_constants(vv, vv_);
    }
    if (by_coefficients_) {
        add_first(rows, {p * fu, q * fv});
    }
}

// Whether a first derivative may differ by more than a tenth.
bool HessianBox::is_coarse() const noexcept {
    double first = 0, second = 0;
    for (size_t c = 0; c < 3; ++c) {
        first = std::max({first, std::abs(first_[0][c]), std::abs(first_[1][c])});
        second = std::max({second, uu_[c].most(), uv_[c].most(), vv_[c].most()});
    }
    return second > 0.1 * first;
}

void HessianBox::add_first(const CoefficientNet &net, const std::array<double, 2> &factors) noexcept {
    double reach = 0; // squares
    for (int i = 0; i < net.u * net.v; ++i) {
        reach = std::max(reach, square3(Four(net.rows + 4 * i)));
    }
    coefficient_reach_ = std::max(coefficient_reach_, std::sqrt(reach) * (1 + 4 * eps) + 4 * noise_);
    for (const size_t k : {size_t{0}, size_t{1}}) {
        const Four mean(first_[k]);
        const int step = net.step(static_cast<int>(k)), u = net.u - (k == 0 ? 1 : 0),
                  v = net.v - (k == 0 ? 0 : 1);
        double radius = 0, weight = 0;
        for (int i = 0; i < u; ++i) {
            for (int j = 0; j < v; ++j) {
                const double *x = net.row(i, j);
                const Four first = (Four(x + step) - Four(x)) * factors[k];
                radius = std::max(radius, square3(first - mean));
                weight = std::max(weight, std::abs(first[3]));
            }
        }
        const double noise = 4 * noise_ * factors[k];
        first_radius_[k] = std::max(first_radius_[k], std::sqrt(radius) * (1 + 4 * eps) + noise);
        first_weight_[k] = std::max(first_weight_[k], weight + noise);
    }
}

// d . (A - w P) = d . (A - w O) + d . (O - P) w. The axes are orthonormal to a few eps.
Hessian HessianBox::along(const Vector3 &d, const Vector3 &p) const noexcept {
    const Four factors(dot(d, axes_[0]), dot(d, axes_[1]), dot(d, axes_[2]), dot(d, origin_ - p));
    const Four sizes = abs(factors), at_least_one = greatest(sizes, Four(1));
    const auto sum = [&](const Ranges &ranges) {
        const double all = (at_least_one * most(ranges)).sum();
        return Range{(factors * Four(ranges.middle)).sum(), (factors * Four(ranges.u)).sum(),
                     (factors * Four(ranges.v)).sum(), (sizes * Four(ranges.radius)).sum() + 16 * eps * all};
    };
    return {sum(uu_), sum(uv_), sum(vv_)};
}

Hessian HessianBox::size(const Vector3 &p, double distance) const noexcept {
    const Vector3 off = origin_ - p;
    const Four moved(dot(axes_[0], off), dot(axes_[1], off), dot(axes_[2], off), 0);
    const double noise = 16 * eps * length(off);
    const auto radius = [&](const Ranges &ranges) {
        const Four middle = Four(ranges.middle) + moved * ranges.middle[3],
                   u = Four(ranges.u) + moved * ranges.u[3], v = Four(ranges.v) + moved * ranges.v[3],
                   rest = Four(ranges.radius) + abs(moved) * ranges.radius[3];
        const Four all = abs(middle) + (abs(u) + abs(v)) * 0.5 + rest;
        const double squares = all[0] * all[0] + all[1] * all[1] + all[2] * all[2];
        return Range{0, 0, 0, (std::sqrt(squares) + (distance + noise) * ranges[3].most()) * (1 + 32 * eps)};
    };
    return {radius(uu_), radius(uv_), radius(vv_)};
}

// What constant second derivatives make of a first one differs from its mean by a half of each at most. What these differ from constants
// adds what it may do on the way from the middle, and to the mean: a quarter more along the axis, and a half across. That of a function from
// the bilinear one of its corners is an eighth of the second ones along both axes.
HessianBox::First HessianBox::first(size_t k) const noexcept {
    const Ranges &along = k == 0 ? uu_ : vv_;
    const auto differs = [&](size_t c) {
        return (std::abs(along.middle[c]) + std::abs(uv_.middle[c])) / 2 + 0.75 * along[c].width() +
               uv_[c].width() + 8 * noise_;
    };
    First result{{first_[k][0], first_[k][1], first_[k][2]}, first_radius_[k], first_weight_[k]};
    if (by_coefficients_) {
        return result;
    }
    result.radius = 0;
    for (size_t c = 0; c < 3; ++c) {
        result.radius += differs(c) * differs(c);
    }
    result.radius = std::sqrt(result.radius);
    result.weight = std::abs(first_[k][3]) + differs(3);
    return result;
}

double HessianBox::reach() const noexcept {
    if (by_coefficients_) {
        return coefficient_reach_;
    }
    double squares = 0;
    for (size_t c = 0; c < 3; ++c) {
        const double over = (uu_[c].most() + vv_[c].most()) / 8 + 4 * noise_;
        squares += over * over;
    }
    return reach_ + std::sqrt(squares);
}

// S' = (A' - S w') / w about the origin, with a middle of the one and the rest for what is left.
double HessianBox::move(double u, double v) const noexcept {
    const double w = least_weight_, far = reach();
    const std::array<First, 2> both{first(0), first(1)};
    std::array<double, 3> middle{};
    for (size_t c = 0; c < 3; ++c) {
        middle[c] = (u * both[0].middle[c] + v * both[1].middle[c]) / w;
    }
    const double size = std::sqrt(middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2]);
    const double rest = std::abs(u) * (both[0].radius + far * both[0].weight / w) +
                        std::abs(v) * (both[1].radius + far * both[1].weight / w);
    return (size + rest / w) * (1 + 64 * eps);
}

} // namespace nrb::mesh
