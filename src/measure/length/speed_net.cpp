// SPDX-License-Identifier: MIT
#include "measure/length/speed_net.h"

#include "base/numbers.h"
#include "bernstein/de_casteljau.h"
#include "numeric/binomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nrb::measure {

namespace {

struct Extent {
    double least, most;
};

// The range of the weights' magnitudes; least <= 0 if they do not have one sign.
Extent weight_extent(int degree, const double *w) noexcept {
    if (degree < 0) {
        return {1, 1};
    }
    const double sign = w[0] < 0 ? -1 : 1;
    Extent extent{sign * w[0], sign * w[0]};
    for (int i = 1; i <= degree; ++i) {
        extent.least = std::min(extent.least, sign * w[i]);
        extent.most = std::max(extent.most, sign * w[i]);
    }
    return extent;
}

// kDegree: 0 if it is not a compile-time constant. The loops contain no branches, because on a tangled curve
// it is as good as random whether a coefficient passes.
template <int kDegree>
NetShape shape_of(const SpeedForm &form, const double *net) noexcept {
    constexpr double least_cosine = 0.25, most_ratio = 64, none = 1e-8;
    constexpr size_t room = kDegree == 0 ? max_product_degree + 1 : kDegree + 1;
    const auto count = static_cast<size_t>((kDegree == 0 ? form.degree : kDegree) + 1);
    std::array<double, room> along{}, squares{};
    double square = 0;
    for (int c = 0; c < form.dim; ++c, net += count) {
        double sum = 0;
        for (size_t i = 0; i < count; ++i) {
            sum += net[i];
        }
        for (size_t i = 0; i < count; ++i) {
            along[i] += sum * net[i];
            squares[i] += net[i] * net[i];
        }
        square += sum * sum;
    }
    double largest = squares[0];
    for (size_t i = 1; i < count; ++i) {
        largest = std::max(largest, squares[i]);
    }
    const double upper = largest / (most_ratio * most_ratio), lower = none * none * largest;
    const double least = least_cosine * least_cosine * square;
    double beside = -infinity, between = -infinity; // positive if a coefficient is beside, or between
    for (size_t i = 0; i < count; ++i) {
        beside = std::max(beside, least * squares[i] - along[i] * std::abs(along[i]));
        between = std::max(between, std::min(upper - squares[i], squares[i] - lower));
    }
    const Extent weights = weight_extent(form.weight_degree, net);
    return {beside <= 0 && between <= 0 && weights.most <= most_ratio * weights.least,
            square < infinity ? largest : infinity, weights.least};
}

// subdivide() for one row in registers. Compilers otherwise store pairs of numbers and load other pairs that
// straddle them, which stalls processors.
template <size_t kDegree>
void halve_row(const std::array<double, kDegree + 1> &row, double *values, double *lower) noexcept {
    lower[0] = row[0];
    values[kDegree] = row[kDegree];
    if constexpr (kDegree > 0) {
        [&]<size_t... i>(std::index_sequence<i...>) {
            halve_row<kDegree - 1>({0.5 * (row[i] + row[i + 1])...}, values, lower + 1);
        }
        (std::make_index_sequence<kDegree>());
    }
}

template <size_t kDegree>
void halve_rows(int rows, double scale, double *values, double *lower) noexcept {
    for (int r = 0; r < rows; ++r, values += kDegree + 1, lower += kDegree + 1) {
        [&]<size_t... i>(std::index_sequence<i...>) {
            halve_row<kDegree>({scale * values[i]...}, values, lower);
        }
        (std::make_index_sequence<kDegree + 1>());
    }
}

void halve_rows(int rows, int degree, double scale, double *values, double *lower) noexcept {
    switch (degree) {
    case 2:
        return halve_rows<2>(rows, scale, values, lower);
    case 3:
        return halve_rows<3>(rows, scale, values, lower);
    case 4:
        return halve_rows<4>(rows, scale, values, lower);
    default:
        std::for_each_n(values, rows * (degree + 1), [=](double &x) { x *= scale; });
        subdivide({rows, degree, 1}, 0.5, values, lower);
    }
}

void cross_terms(int p, const double *a, const double *w, double *out) noexcept {
    const double *choose = binomials(p), *whole = binomials(2 * p - 2);
    std::fill_n(out, 2 * p - 1, 0.0);
    for (int i = 0; i < p; ++i) {
        for (int j = i + 1; j <= p; ++j) {
            out[i + j - 1] += (j - i) * choose[i] * choose[j] * (a[j] * w[i] - a[i] * w[j]);
        }
    }
    for (int i = 0; i < 2 * p - 1; ++i) {
        out[i] /= whole[i];
    }
}

// For cubics, with all factors as constants.
void cross_terms_of_cubic(const double *a, const double *w, double *out) noexcept {
    const auto cross = [&](int i, int j) { return a[j] * w[i] - a[i] * w[j]; };
    out[0] = 3 * cross(0, 1);
    out[1] = 1.5 * cross(0, 2);
    out[2] = 0.5 * cross(0, 3) + 1.5 * cross(1, 2);
    out[3] = 1.5 * cross(1, 3);
    out[4] = 3 * cross(2, 3);
}

} // namespace

double NetShape::bound() const noexcept {
    return weight > 0 ? std::sqrt(square) / (weight * weight) : infinity;
}

NetShape net_shape(const SpeedForm &form, const double *net) noexcept {
    return form.degree == 4   ? shape_of<4>(form, net)
           : form.degree == 2 ? shape_of<2>(form, net)
                              : shape_of<0>(form, net);
}

void wronskian(int p, const double *a, const double *w, double *out) noexcept {
    p == 3 ? cross_terms_of_cubic(a, w, out) : cross_terms(p, a, w, out);
}

void halve_net(const SpeedForm &form, double *net, double *lower) noexcept {
    const int first = form.dim * (form.degree + 1);
    halve_rows(form.dim, form.degree, 0.5, net, lower);
    if (form.weight_degree >= 0) {
        halve_rows(1, form.weight_degree, 1.0, net + first, lower + first);
    }
}

} // namespace nrb::measure
