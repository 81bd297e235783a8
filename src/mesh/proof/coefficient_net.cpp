// SPDX-License-Identifier: MIT
#include "mesh/proof/coefficient_net.h"

#include <cmath>

namespace nrb::mesh {

void differences(const CoefficientNet &net, int axis, CoefficientNet &out) noexcept {
    const int step = net.step(axis);
    out.u = net.u - (axis == 0 ? 1 : 0);
    out.v = net.v - (axis == 0 ? 0 : 1);
    for (int i = 0; i < out.u; ++i) {
        const double *x = net.row(i, 0);
        double *to = out.row(i, 0);
        for (int j = 0; j < out.v; ++j, x += 4, to += 4) {
            (Four(x + step) - Four(x)).store(to);
        }
    }
}

namespace {

// Roundings of sums of coefficients, at most, in units of their size.
constexpr double roundings = 16;

// The Bernstein coefficients of x, x^2 and x^3.
class Powers {
public:
    explicit Powers(int degree) noexcept {
        for (int k = 0; k < 3; ++k) {
            inverse_[static_cast<size_t>(k)] = degree > k ? 1.0 / (degree - k) : 0;
        }
    }
    [[nodiscard]] std::array<double, 3> at(int i) const noexcept {
        const double one = i * inverse_[0], two = one * (i - 1) * inverse_[1];
        return {one, two, two * (i - 2) * inverse_[2]};
    }

private:
    std::array<double, 3> inverse_{};
};

// One number of the ranges of all coordinates.
Four lanes(const std::array<Hessian, 4> &hessians, Range Hessian::*range, double Range::*number) noexcept {
    return {hessians[0].*range.*number, hessians[1].*range.*number, hessians[2].*range.*number,
            hessians[3].*range.*number};
}

// A polynomial in x and y from 0 to 1: terms[k][l] x^k y^l, where k + l <= 3.
using Cubic = std::array<std::array<Four, 4>, 4>;

Cubic cubic_of(const CoefficientNet &net, const std::array<Hessian, 4> &hessians) noexcept {
    const auto of = [&](Range Hessian::*range, double Range::*number) {
        return lanes(hessians, range, number);
    };
    const Four uuu = of(&Hessian::uu, &Range::u), uuv = of(&Hessian::uu, &Range::v),
               uvv = of(&Hessian::vv, &Range::u), vvv = of(&Hessian::vv, &Range::v);
    Cubic terms;
    terms[2][0] = (of(&Hessian::uu, &Range::middle) - (uuu + uuv) * 0.5) * 0.5;
    terms[1][1] = of(&Hessian::uv, &Range::middle) - (uuv + uvv) * 0.5;
    terms[0][2] = (of(&Hessian::vv, &Range::middle) - (uvv + vvv) * 0.5) * 0.5;
    terms[3][0] = uuu * (1.0 / 6);
    terms[2][1] = uuv * 0.5;
    terms[1][2] = uvv * 0.5;
    terms[0][3] = vvv * (1.0 / 6);
    terms[0][0] = net.at(0, 0);
    terms[1][0] = net.at(net.u - 1, 0) - terms[0][0] - terms[2][0] - terms[3][0];
    terms[0][1] = net.at(0, net.v - 1) - terms[0][0] - terms[0][2] - terms[0][3];
    return terms;
}

// An upper bound on its coefficients, rounded.
Four size_of(const Cubic &terms) noexcept {
    Four size;
    for (const auto &row : terms) {
        for (const Four &term : row) {
            size = size + abs(term);
        }
    }
    return size;
}

} // namespace

std::array<Range, 4> ranges_of_differences(const CoefficientNet &net, int axis, double factor, double error,
                                           bool planes) noexcept {
    const int step = net.step(axis), m = net.u - (axis == 0 ? 1 : 0), n = net.v - (axis == 0 ? 0 : 1);
    if (m <= 0 || n <= 0 || factor == 0) {
        return {};
    }
    const auto at = [step](const double *x) { return Four(x + step) - Four(x); };
    Four u, v, low(infinity), high(-infinity), sum;
    if (planes) { // the mean of a function is that of its coefficients
        for (int j = 0; j < n; ++j) {
            u = u + (at(net.row(m - 1, j)) - at(net.row(0, j)));
        }
        for (int i = 0; i < m; ++i) {
            v = v + (at(net.row(i, n - 1)) - at(net.row(i, 0)));
        }
        u = u * (1.0 / n);
        v = v * (1.0 / m);
    }
    const double u_step = m > 1 ? 1.0 / (m - 1) : 0, v_step = n > 1 ? 1.0 / (n - 1) : 0;
    for (int i = 0; i < m; ++i) {
        const Four along = u * (m > 1 ? i * u_step - 0.5 : 0);
        const double *x = net.row(i, 0);
        for (int j = 0; j < n; ++j, x += 4) {
            const Four rest = at(x) - (along + v * (n > 1 ? j * v_step - 0.5 : 0));
            low = least(low, rest);
            high = greatest(high, rest);
            sum = sum + rest;
        }
    }
    const Four middle = planes ? sum * (1.0 / (m * n)) : (low + high) * 0.5;
    const Four size = greatest(abs(low), abs(high)) + abs(u) + abs(v);
    const std::array<Four, 4> ranges =
        transposed({middle * factor, u * factor, v * factor,
                    (greatest(high - middle, middle - low) + Four(error) + size * (roundings * eps)) *
                        std::abs(factor)});
    return {range_of(ranges[0]), range_of(ranges[1]), range_of(ranges[2]), range_of(ranges[3])};
}

Four distances_from_cubics(const CoefficientNet &net, const std::array<Hessian, 4> &hessians) noexcept {
    const Cubic terms = cubic_of(net, hessians);
    const Powers u(net.u - 1), v(net.v - 1);
    Four most;
    for (int i = 0; i < net.u; ++i) {
        const auto [x, xx, xxx] = u.at(i);
        const Four one = terms[0][0] + terms[1][0] * x + terms[2][0] * xx + terms[3][0] * xxx,
                   y = terms[0][1] + terms[1][1] * x + terms[2][1] * xx, yy = terms[0][2] + terms[1][2] * x;
        for (int j = 0; j < net.v; ++j) {
            const auto [b, bb, bbb] = v.at(j);
            most = greatest(most, abs(net.at(i, j) - (one + y * b + yy * bb + terms[0][3] * bbb)));
        }
    }
    return most + size_of(terms) * (4 * roundings * eps);
}

} // namespace nrb::mesh
