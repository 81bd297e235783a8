// SPDX-License-Identifier: MIT
#include "mesh/proof/hessian_box.h"

#include "base/scratch.h"
#include "mesh/proof/coefficient_net.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// Transforms coefficients (x, y, z, w) to an origin and axes.
class Axes {
public:
    Axes(const Vector3 &origin, const std::array<Vector3, 3> &axes) noexcept
        : origin_(origin), x_(axes[0].x, axes[1].x, axes[2].x, 0), y_(axes[0].y, axes[1].y, axes[2].y, 0),
          z_(axes[0].z, axes[1].z, axes[2].z, 0) {}

    [[nodiscard]] Four of(const double *row) const noexcept {
        const double w = row[3];
        return x_ * (row[0] - w * origin_.x) + y_ * (row[1] - w * origin_.y) + z_ * (row[2] - w * origin_.z) +
               Four(0, 0, 0, w);
    }

private:
    Vector3 origin_;
    Four x_, y_, z_;
};

Range constant(const Range &range) noexcept {
    return {range.middle, 0, 0, range.width() * (1 + 4 * eps)};
}

// The result is a constant, with the slopes of both in its radius.
void join(const Range &other, Range &range) noexcept {
    const double low = std::min(range.middle - range.width(), other.middle - other.width()),
                 high = std::max(range.middle + range.width(), other.middle + other.width());
    range = {(low + high) / 2, 0, 0, (high - low) / 2 + 4 * eps * std::max(std::abs(low), std::abs(high))};
}

} // namespace

Hessian Hessian::anywhere() const noexcept {
    return {constant(uu), constant(uv), constant(vv)};
}

void Hessian::add(const Hessian &other) noexcept {
    join(other.uu, uu);
    join(other.uv, uv);
    join(other.vv, vv);
    rest = infinity;
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
    const Axes own(origin, axes);
    const Four a = own.of(corners[0]), b = own.of(corners[1]), c = own.of(corners[2]), d = own.of(corners[3]);
    (((b - a) + (c - d)) * 0.5).store(first_[0].data());
    (((d - a) + (c - b)) * 0.5).store(first_[1].data());
    corner_weight_ = (a[3] + b[3] + c[3] + d[3]) / 4;
    for (const Four &x : {a, b, c, d}) {
        reach_ = std::max(reach_, square3(x));
    }
    reach_ = std::sqrt(reach_);
}

void HessianBox::add(int u_degree, int v_degree, const double *net, const std::array<double, 2> &factors,
                     double noise, bool steps) {
    const bool fresh = largest_weight_ < least_weight_;
    const int m = u_degree + 1, n = v_degree + 1;
    const auto size = static_cast<size_t>(m * n) * coordinates;
    Scratch scratch(3 * size);
    CoefficientNet rows{m, n, scratch.take(size)};
    std::array<CoefficientNet, 2> first{{{0, 0, scratch.take(size)}, {0, 0, scratch.take(size)}}};
    const Axes axes(origin_, axes_);
    for (size_t i = 0; i < size; i += coordinates, net += coordinates) {
        axes.of(net).store(rows.rows + i);
        least_weight_ = std::min(least_weight_, net[3]);
        largest_weight_ = std::max(largest_weight_, net[3]);
    }
    noise_ = std::max(noise_, noise * largest_weight_);
    differences(rows, 0, first[0]);
    differences(rows, 1, first[1]);
    const std::array<double, 2> degrees{static_cast<double>(u_degree), static_cast<double>(v_degree)};
    add_second(first, degrees, factors, fresh);
    if (fresh && factors == std::array{1.0, 1.0}) {
        set_rests(rows);
    }
    if (fresh) {
        by_coefficients_ = steps && is_coarse();
    }
    if (by_coefficients_) {
        add_first(first, {degrees[0] * factors[0], degrees[1] * factors[1]});
        add_reach(rows);
    }
}

void HessianBox::add_second(const std::array<CoefficientNet, 2> &first, const std::array<double, 2> &degrees,
                            const std::array<double, 2> &factors, bool fresh) noexcept {
    const auto [p, q] = degrees;
    const auto [fu, fv] = factors;
    const bool whole = fu == 1 && fv == 1;
    // The weights of a second difference, 1, -2, 1 or 1, -1, -1, 1, have magnitudes that add up to 4.
    const double error = 4 * noise_;
    const auto uu = ranges_of_differences(first[0], 0, p * (p - 1) * fu * fu, error, whole),
               uv = ranges_of_differences(first[0], 1, p * q * fu * fv, error, whole),
               vv = ranges_of_differences(first[1], 1, q * (q - 1) * fv * fv, error, whole);
    for (size_t c = 0; c < coordinates; ++c) {
        Hessian &own = of_[c];
        if (fresh) {
            own = {uu[c], uv[c], vv[c]};
        } else {
            own.add({uu[c], uv[c], vv[c]});
        }
    }
    set_sizes();
}

// Errors of coefficients count twice: at a place, and in the interpolant.
void HessianBox::set_rests(const CoefficientNet &net) noexcept {
    const Four rests = distances_from_cubics(net, of_) + Four(2 * noise_);
    for (size_t c = 0; c < coordinates; ++c) {
        of_[c].rest = rests[c];
    }
}

void HessianBox::set_sizes() noexcept {
    constexpr std::array<Range Hessian::*, 3> parts{&Hessian::uu, &Hessian::uv, &Hessian::vv};
    for (size_t k = 0; k < 3; ++k) {
        const auto most = [&](size_t c) { return (of_[c].*parts[k]).most(); };
        const double x = most(0), y = most(1), z = most(2);
        weights_[k] = most(3);
        sums_[k] = x + y + z + weights_[k];
        sizes_[k] = std::sqrt(x * x + y * y + z * z) * (1 + 8 * eps);
    }
}

// Whether first derivatives may vary by more than a tenth of the largest one.
bool HessianBox::is_coarse() const noexcept {
    double first = 0, second = 0;
    for (size_t c = 0; c < 3; ++c) {
        first = std::max({first, std::abs(first_[0][c]), std::abs(first_[1][c])});
        second = std::max({second, of_[c].uu.most(), of_[c].uv.most(), of_[c].vv.most()});
    }
    return second > 0.1 * first;
}

void HessianBox::add_reach(const CoefficientNet &net) noexcept {
    double reach = 0; // squared
    for (int i = 0; i < net.u * net.v; ++i) {
        reach = std::max(reach, square3(Four(net.rows + 4 * i)));
    }
    coefficient_reach_ = std::max(coefficient_reach_, std::sqrt(reach) * (1 + 4 * eps) + 4 * noise_);
}

// factors: what the differences of coefficients are multiplied by.
void HessianBox::add_first(const std::array<CoefficientNet, 2> &first,
                           const std::array<double, 2> &factors) noexcept {
    for (const size_t k : {size_t{0}, size_t{1}}) {
        const Four mean(first_[k]);
        Four most;
        double radius = 0;
        for (int i = 0; i < first[k].u * first[k].v; ++i) {
            const Four own = Four(first[k].rows + 4 * i) * factors[k];
            radius = std::max(radius, square3(own - mean));
            most = greatest(most, abs(own));
        }
        const double noise = 4 * noise_ * factors[k];
        first_radius_[k] = std::max(first_radius_[k], std::sqrt(radius) * (1 + 4 * eps) + noise);
        first_weight_[k] = std::max(first_weight_[k], most[3] + noise);
    }
}

// d . (A - w P) = d . (A - w O) + d . (O - P) w. The noise covers the axes, which are orthonormal to a few
// eps, and the rounding of the sums.
Hessian HessianBox::along(const Vector3 &d, const Vector3 &p) const noexcept {
    const std::array<double, coordinates> factors{dot(d, axes_[0]), dot(d, axes_[1]), dot(d, axes_[2]),
                                                  dot(d, origin_ - p)};
    Four uu, uv, vv;
    double rest = 0;
    for (size_t c = 0; c < coordinates; ++c) {
        const double f = factors[c];
        const Four all(f, f, f, std::abs(f));
        uu = uu + four_of(of_[c].uu) * all;
        uv = uv + four_of(of_[c].uv) * all;
        vv = vv + four_of(of_[c].vv) * all;
        rest += of_[c].rest * std::abs(f);
    }
    const double noise = 32 * eps * std::max(1.0, std::abs(factors[3]));
    return {range_of(uu + Four(0, 0, 0, noise * sums_[0])), range_of(uv + Four(0, 0, 0, noise * sums_[1])),
            range_of(vv + Four(0, 0, 0, noise * sums_[2])), rest + noise * (sums_[0] + sums_[1] + sums_[2])};
}

// All coordinates at once, one in each lane.
Hessian HessianBox::size(const Vector3 &p) const noexcept {
    const Vector3 off = origin_ - p;
    const Four moved(dot(axes_[0], off), dot(axes_[1], off), dot(axes_[2], off), 0);
    const double noise = 16 * eps * length(off);
    const auto radius = [&](Range Hessian::*part, double most_of_weight) {
        const Range &w = of_[3].*part;
        const auto [middle, u, v, rest] =
            transposed({four_of(of_[0].*part), four_of(of_[1].*part), four_of(of_[2].*part), four_of(w)});
        const Four all = abs(middle + moved * w.middle) +
                         (abs(u + moved * w.u) + abs(v + moved * w.v)) * 0.5 + rest + abs(moved) * w.radius;
        return Range{0, 0, 0, (std::sqrt(square3(all)) + noise * most_of_weight) * (1 + 32 * eps)};
    };
    return {radius(&Hessian::uu, weights_[0]), radius(&Hessian::uv, weights_[1]),
            radius(&Hessian::vv, weights_[2])};
}

Hessian HessianBox::sizes(const Vector3 &p, double distance) const noexcept {
    const double far = distance + length(origin_ - p);
    const auto radius = [&](size_t k) {
        return Range{0, 0, 0, (sizes_[k] + far * weights_[k]) * (1 + 16 * eps)};
    };
    return {radius(0), radius(1), radius(2)};
}

// Bounds the deviation of the first derivative F along axis k from its mean M over the two sides of the cell
// along that axis. The second derivative along the axis is within A of a constant a, and the mixed one within
// B of a constant b. The constants let F differ from M by at most |a| / 2 + |b| / 2. The remainders add at
// most A / 2 + B / 2 on the way from the middle of the cell, and A / 4 + B / 2 between the middle and the
// mean.
HessianBox::First HessianBox::first(size_t k) const noexcept {
    const auto differs = [&](size_t c) {
        const Range &along = k == 0 ? of_[c].uu : of_[c].vv, &across = of_[c].uv;
        return (std::abs(along.middle) + std::abs(across.middle)) / 2 + 0.75 * along.width() +
               across.width() + 8 * noise_;
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

// The bilinear interpolant of the corners differs from a linear function by at most a quarter of its twist,
// which is the mean of the mixed derivative.
double HessianBox::weight_from_below(const std::array<double, 2> &place) const noexcept {
    const Hessian &w = of_[3];
    const double off = w.uv.most() / 4 + (w.uu.most() + w.vv.most()) / 8 + 8 * noise_;
    return corner_weight_ + first_[0][3] * place[0] + first_[1][3] * place[1] - off;
}

// A function differs from the bilinear interpolant of its corners by at most an eighth of the largest second
// derivatives along both axes.
double HessianBox::reach() const noexcept {
    if (by_coefficients_) {
        return coefficient_reach_;
    }
    double squares = 0;
    for (size_t c = 0; c < 3; ++c) {
        const double over = (of_[c].uu.most() + of_[c].vv.most()) / 8 + 4 * noise_;
        squares += over * over;
    }
    return reach_ + std::sqrt(squares);
}

// About the origin, S' = (A' - S w') / w. The middles of A' are added up as vectors; the bounds on all the
// rest are added to the length.
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
