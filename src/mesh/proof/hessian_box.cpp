// SPDX-License-Identifier: MIT
#include "mesh/proof/hessian_box.h"

#include "base/scratch.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

constexpr size_t width = HessianBox::coordinates;
using Row = std::array<double, width>;
using Ranges = std::array<Range, width>;

// Bernstein coefficients [u][v] of a derivative.
class Net {
public:
    explicit Net(double *rows) noexcept : rows_(rows) {}
    void resize(int u_count, int v_count) noexcept {
        u_ = u_count;
        v_ = v_count;
    }
    [[nodiscard]] bool empty() const noexcept { return u_ <= 0 || v_ <= 0; }
    void set(int i, int j, const Row &row) noexcept { std::ranges::copy(row, rows_ + (i * v_ + j) * 4); }
    [[nodiscard]] Row at(int i, int j) const noexcept {
        const double *row = rows_ + (i * v_ + j) * 4;
        return {row[0], row[1], row[2], row[3]};
    }

    // Times a factor. The plane is that through the means of the corners; a plane has the coefficients of its values at the places
    // of control points, so that what coefficients differ from it bounds what the function does.
    [[nodiscard]] Ranges ranges(double factor, double noise, bool planes) const noexcept;
    // The least and the largest of each component.
    struct Extremes {
        Row low, high;
    };
    [[nodiscard]] Extremes extremes() const noexcept;

private:
    int u_ = 0, v_ = 0;
    double *rows_; // [u][v]
};

Net::Extremes Net::extremes() const noexcept {
    Extremes result{at(0, 0), at(0, 0)};
    for (int i = 0; i < u_ * v_; ++i) {
        for (size_t c = 0; c < width; ++c) {
            const double x = rows_[static_cast<size_t>(i) * width + c];
            result.low[c] = std::min(result.low[c], x);
            result.high[c] = std::max(result.high[c], x);
        }
    }
    return result;
}

Ranges Net::ranges(double factor, double noise, bool planes) const noexcept {
    Ranges result{};
    if (empty() || factor == 0) {
        return result;
    }
    const Row a = at(0, 0), b = at(u_ - 1, 0), c = at(u_ - 1, v_ - 1), d = at(0, v_ - 1);
    Row low, high, u{}, v{};
    low.fill(infinity);
    high.fill(-infinity);
    for (size_t k = 0; planes && k < width; ++k) {
        u[k] = ((b[k] - a[k]) + (c[k] - d[k])) / 2;
        v[k] = ((d[k] - a[k]) + (c[k] - b[k])) / 2;
    }
    for (int i = 0; i < u_; ++i) {
        const double x = u_ > 1 ? i / (u_ - 1.0) - 0.5 : 0;
        for (int j = 0; j < v_; ++j) {
            const double y = v_ > 1 ? j / (v_ - 1.0) - 0.5 : 0;
            const Row row = at(i, j);
            for (size_t k = 0; k < width; ++k) {
                const double rest = row[k] - (u[k] * x + v[k] * y);
                low[k] = std::min(low[k], rest);
                high[k] = std::max(high[k], rest);
            }
        }
    }
    for (size_t k = 0; k < width; ++k) {
        const double size = std::max(std::abs(low[k]), std::abs(high[k])) + std::abs(u[k]) + std::abs(v[k]);
        result[k] = {factor * (low[k] + high[k]) / 2, factor * u[k], factor * v[k],
                     std::abs(factor) * ((high[k] - low[k]) / 2 + noise + 8 * eps * size)};
    }
    return result;
}

// The products of a coefficient row with the axes, about the origin.
Row in_axes(const double *row, const Vector3 &origin, const std::array<Vector3, 3> &axes) noexcept {
    const double w = row[3];
    const Vector3 a{row[0] - w * origin.x, row[1] - w * origin.y, row[2] - w * origin.z};
    return {dot(axes[0], a), dot(axes[1], a), dot(axes[2], a), w};
}

Row difference(const Row &a, const Row &b) noexcept {
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2], b[3] - a[3]};
}

void differentiate_u(const Net &net, int u_count, int v_count, Net &out) noexcept {
    out.resize(u_count - 1, v_count);
    for (int i = 0; i + 1 < u_count; ++i) {
        for (int j = 0; j < v_count; ++j) {
            out.set(i, j, difference(net.at(i, j), net.at(i + 1, j)));
        }
    }
}

void differentiate_v(const Net &net, int u_count, int v_count, Net &out) noexcept {
    out.resize(u_count, v_count - 1);
    for (int i = 0; i < u_count; ++i) {
        for (int j = 0; j + 1 < v_count; ++j) {
            out.set(i, j, difference(net.at(i, j), net.at(i, j + 1)));
        }
    }
}

Range constant(const Range &range) noexcept {
    return {range.middle, 0, 0, range.width() * (1 + 4 * eps)};
}

void add_constant(const Range &other, Range &range) noexcept {
    const double low = std::min(range.middle - range.radius, other.middle - other.radius),
                 high = std::max(range.middle + range.radius, other.middle + other.radius);
    range = {(low + high) / 2, 0, 0, (high - low) / 2 + 4 * eps * std::max(std::abs(low), std::abs(high))};
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

void HessianBox::add(int u_degree, int v_degree, const double *net, const std::array<double, 2> &factors,
                     double noise) {
    const bool whole = factors[0] == 1 && factors[1] == 1, fresh = largest_weight_ < least_weight_;
    const int m = u_degree + 1, n = v_degree + 1;
    const auto size = static_cast<size_t>(m * n) * width;
    Scratch scratch(3 * size);
    Net rows(scratch.take(size)), first(scratch.take(size)), second(scratch.take(size));
    rows.resize(m, n);
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < n; ++j, net += width) {
            rows.set(i, j, in_axes(net, origin_, axes_));
            least_weight_ = std::min(least_weight_, net[3]);
            largest_weight_ = std::max(largest_weight_, net[3]);
        }
    }
    const double p = u_degree, q = v_degree, fu = factors[0], fv = factors[1],
                 error = noise * largest_weight_;
    const Net::Extremes all = rows.extremes();
    double reach = 0;
    for (size_t c = 0; c < 3; ++c) {
        const double most = std::max(std::abs(all.low[c]), std::abs(all.high[c])) + error;
        reach += most * most;
    }
    reach_ = std::max(reach_, std::sqrt(reach));
    differentiate_u(rows, m, n, first);
    add_first(0, {first.extremes().low, first.extremes().high}, p * fu, error, fresh);
    differentiate_u(first, m - 1, n, second);
    const Ranges uu = second.ranges(p * (p - 1) * fu * fu, error, whole);
    differentiate_v(first, m - 1, n, second);
    const Ranges uv = second.ranges(p * q * fu * fv, error, whole);
    differentiate_v(rows, m, n, first);
    add_first(1, {first.extremes().low, first.extremes().high}, q * fv, error, fresh);
    differentiate_v(first, m, n - 1, second);
    const Ranges vv = second.ranges(q * (q - 1) * fv * fv, error, whole);
    for (size_t c = 0; c < coordinates; ++c) {
        if (fresh) {
            uu_[c] = uu[c];
            uv_[c] = uv[c];
            vv_[c] = vv[c];
        } else {
            add_constant(uu[c], uu_[c]);
            add_constant(uv[c], uv_[c]);
            add_constant(vv[c], vv_[c]);
        }
    }
}

void HessianBox::add_first(size_t k, const FirstNet &net, double factor, double noise, bool fresh) noexcept {
    First own;
    double squares = 0;
    for (size_t c = 0; c < 3; ++c) {
        own.middle[c] = factor * (net.low[c] + net.high[c]) / 2;
        const double radius = factor * ((net.high[c] - net.low[c]) / 2 + 2 * noise);
        squares += radius * radius;
    }
    own.radius = std::sqrt(squares);
    own.weight = factor * (std::max(std::abs(net.low[3]), std::abs(net.high[3])) + 2 * noise);
    First &all = first_[k];
    if (fresh) {
        all = own;
        return;
    }
    const double apart = std::hypot(own.middle[0] - all.middle[0], own.middle[1] - all.middle[1],
                                    own.middle[2] - all.middle[2]);
    all.radius = std::max(all.radius, own.radius + apart);
    all.weight = std::max(all.weight, own.weight);
}

// d . (A - w P) = d . (A - w O) + d . (O - P) w. The axes are orthonormal to a few eps.
Hessian HessianBox::along(const Vector3 &d, const Vector3 &p) const noexcept {
    const Row factors{dot(d, axes_[0]), dot(d, axes_[1]), dot(d, axes_[2]), dot(d, origin_ - p)};
    const auto sum = [&](const Ranges &ranges) {
        Range result;
        double all = 0;
        for (size_t c = 0; c < coordinates; ++c) {
            result.middle += factors[c] * ranges[c].middle;
            result.u += factors[c] * ranges[c].u;
            result.v += factors[c] * ranges[c].v;
            result.radius += std::abs(factors[c]) * ranges[c].radius;
            all += std::max(1.0, std::abs(factors[c])) * ranges[c].most();
        }
        result.radius += 16 * eps * all;
        return result;
    };
    return {sum(uu_), sum(uv_), sum(vv_)};
}

Hessian HessianBox::size(const Vector3 &p, double distance) const noexcept {
    const Vector3 off = origin_ - p;
    const Row moved{dot(axes_[0], off), dot(axes_[1], off), dot(axes_[2], off), 0};
    const double noise = 16 * eps * length(off);
    const auto radius = [&](const Ranges &ranges) {
        const Range &w = ranges[3];
        double sum = 0;
        for (size_t c = 0; c < 3; ++c) {
            const Range &a = ranges[c];
            const double middle = std::abs(a.middle + moved[c] * w.middle),
                         u = std::abs(a.u + moved[c] * w.u), v = std::abs(a.v + moved[c] * w.v),
                         rest = a.radius + std::abs(moved[c]) * w.radius;
            const double most = middle + (u + v) / 2 + rest;
            sum += most * most;
        }
        return Range{0, 0, 0, (std::sqrt(sum) + (distance + noise) * w.most()) * (1 + 32 * eps)};
    };
    return {radius(uu_), radius(uv_), radius(vv_)};
}

// S' = (A' - S w') / w about the origin, with a middle of the one and the rest for what is left.
double HessianBox::move(double u, double v) const noexcept {
    const double w = least_weight_;
    const Row middle{(u * first_[0].middle[0] + v * first_[1].middle[0]) / w,
                     (u * first_[0].middle[1] + v * first_[1].middle[1]) / w,
                     (u * first_[0].middle[2] + v * first_[1].middle[2]) / w, 0};
    const double size = std::sqrt(middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2]);
    const double rest = std::abs(u) * (first_[0].radius + reach_ * first_[0].weight / w) +
                        std::abs(v) * (first_[1].radius + reach_ * first_[1].weight / w);
    return (size + rest / w) * (1 + 64 * eps);
}

} // namespace nrb::mesh
