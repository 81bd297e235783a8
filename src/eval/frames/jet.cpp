// SPDX-License-Identifier: MIT
#include "eval/frames/jet.h"

#include "base/numbers.h"
#include "basis/bspline.h"
#include "spline/at_origin.h"

#include <algorithm>
#include <cmath>

namespace nrb::eval {

namespace {

constexpr int orders = max_jet_order + 1;
constexpr int slots = orders * (orders + 1) / 2;

// The Taylor coefficients of the basis functions of one axis, and the sums of the magnitudes of their terms.
// Only the orders that are needed are filled: clearing all of them would take longer than computing a low
// order. A new object stands for the axis that a curve lacks, with the constant function 1.
struct Series {
    Series() noexcept {
        values[0][0] = 1;
        sizes[0][0] = 1;
    }

    int64_t first = 0;
    int functions = 1;
    double side = 1;
    double unit = 1;
    double values[orders][max_basis];
    double sizes[orders][max_basis];
};

// One difference step, in place: from d functions of degree d - 1 to the derivatives of the d + 1 functions
// of degree d (Piegl & Tiller 2.7), times unit * scale.
void differentiate(const double *knots, int d, int64_t span, double unit, double scale, double *values,
                   double *sizes) noexcept {
    const double *right = knots + span + 1;
    const double *left = right - d;
    double carried = 0;
    double carried_size = 0;
    for (int r = 0; r < d; ++r) {
        const double factor = scale * (d * (unit / (right[r] - left[r])));
        const double slope = factor * values[r];
        const double size = std::fabs(factor) * sizes[r];
        values[r] = carried - slope;
        sizes[r] = carried_size + size;
        carried = slope;
        carried_size = size;
    }
    values[d] = carried;
    sizes[d] = carried_size;
}

// Computes Taylor coefficient k by k difference steps from the functions of degree p - k, which are
// relatively accurate. The factor 1 / k! is spread over the steps.
void fill_order(const double *knots, int degree, int64_t span, double t, int k, Series &series) noexcept {
    double *values = series.values[k];
    double *sizes = series.sizes[k];
    basis_values(knots, degree - k, span, t, values);
    for (int j = 0; j <= degree - k; ++j) {
        sizes[j] = std::fabs(values[j]);
    }
    for (int step = 1; step <= k; ++step) {
        differentiate(knots, degree - k + step, span, series.unit, series.side / step, values, sizes);
    }
}

// The power of two nearest below the length of a span, kept within 2^-64 and 2^64. If first derivatives are
// near 1 in these units, the powers of the unit stay so moderate that scaling loses no bits of the
// coefficients.
double unit_of(double length) noexcept {
    constexpr int farthest = 64;
    return std::ldexp(1.0, std::clamp(std::ilogb(length), -farthest, farthest));
}

// Fills the coefficients of one axis up to `order`; false if the parameter gives NaN.
bool fill(const KnotVector &axis, const AxisRule &rule, double t, int order, Series &series) noexcept {
    const double placed = place(t, rule, axis.domain());
    if (std::isnan(placed)) {
        return false;
    }
    const int degree = axis.degree();
    const double *knots = axis.knots().data();
    const int64_t span = axis.spans().find(placed, rule.left);
    const bool above = rule.left ? placed <= knots[span] : placed < knots[span + 1];
    series.first = span - degree;
    series.functions = degree + 1;
    series.side = above ? 1 : -1;
    series.unit = unit_of(knots[span + 1] - knots[span]);
    for (int k = 0; k <= order; ++k) {
        if (k <= degree) {
            fill_order(knots, degree, span, placed, k, series);
        } else {
            std::fill_n(series.values[k], series.functions, 0.0);
            std::fill_n(series.sizes[k], series.functions, 0.0);
        }
    }
    return true;
}

constexpr int max_width = 4;
using Record = std::array<double, max_width>;

// Homogeneous Taylor coefficients and the sums of the magnitudes of their terms, in the slots of a surface.
struct Sums {
    explicit Sums(int order) noexcept {
        std::fill_n(values.begin(), slot_count(2, order), Record{});
        std::fill_n(sizes.begin(), slot_count(2, order), Record{});
    }

    std::array<Record, slots> values;
    std::array<Record, slots> sizes;
};

void add_scaled(double factor, const Record &from, Record &to) noexcept {
    for (size_t c = 0; c < max_width; ++c) {
        to[c] += factor * from[c];
    }
}

// Adds layer i of axis 0: contracts it along axis 1 for each order, then adds the result for each order of
// axis 0.
void add_layer(const Series &u, int i, const Series &v, const double *row, int width, int order, bool surface,
               Sums &sums) noexcept {
    for (int b = 0; b <= (surface ? order : 0); ++b) {
        Record value{};
        Record size{};
        for (int j = 0; j < v.functions; ++j) {
            for (int c = 0; c < width; ++c) {
                const double x = row[j * width + c];
                value[static_cast<size_t>(c)] += v.values[b][j] * x;
                size[static_cast<size_t>(c)] += v.sizes[b][j] * std::fabs(x);
            }
        }
        for (int a = 0; a + b <= order; ++a) {
            const auto at = static_cast<size_t>(slot(2, a, b));
            add_scaled(u.values[a][i], value, sums.values[at]);
            add_scaled(u.sizes[a][i], size, sums.sizes[at]);
        }
    }
}

Sums contract(const Spline &spline, const Series &u, const Series &v, int order) noexcept {
    Sums sums(order);
    const bool surface = spline.axes() == 2;
    const int64_t row_count = surface ? spline.count(1) : 1;
    const double *records = spline.records().data();
    for (int i = 0; i < u.functions; ++i) {
        const double *row = records + ((u.first + i) * row_count + v.first) * spline.width();
        add_layer(u, i, v, row, spline.width(), order, surface, sums);
    }
    return sums;
}

// The quotient rule for Taylor coefficients, C_s = (A_s - sum over 0 < b <= s of w_b C_(s-b)) / w_0, and the
// same in magnitudes, which gives E_a of the accuracy contract in nurbs.h.
void divide(int order, bool surface, int dim, Sums &sums) noexcept {
    const auto w = static_cast<size_t>(dim);
    const double weight = sums.values[0][w];
    for_each_slot(surface ? 2 : 1, order, [&](int i, int j, int) {
        Record &value = sums.values[static_cast<size_t>(slot(2, i, j))];
        Record &size = sums.sizes[static_cast<size_t>(slot(2, i, j))];
        const double own_weight = value[w];
        const double own_size = size[w];
        for (int a = 0; a <= i; ++a) {
            for (int b = a == 0 ? 1 : 0; b <= j; ++b) {
                const auto here = static_cast<size_t>(slot(2, a, b));
                const auto rest = static_cast<size_t>(slot(2, i - a, j - b));
                const bool last = a == i && b == j;
                add_scaled(last ? -own_weight : -sums.values[here][w], sums.values[rest], value);
                add_scaled(last ? own_size : sums.sizes[here][w], sums.sizes[rest], size);
            }
        }
        for (size_t c = 0; c < w; ++c) {
            value[c] /= weight;
            size[c] /= std::fabs(weight);
        }
        value[w] = own_weight;
        size[w] = own_size;
    });
}

Vector3 vector(const Record &record, int dim) noexcept {
    return {record[0], record[1], dim == 3 ? record[2] : 0.0};
}

} // namespace

double accuracy_factor(int degree) noexcept {
    static constexpr double low[] = {1, 3, 4, 4, 6, 6, 8, 8, 12, 12};
    return degree < 10 ? low[degree] : degree < 16 ? 16 : degree < 24 ? 24 : 32;
}

void Jet::prepare(const Spline &spline) {
    static_cast<void>(at_origin(spline).records());
    for (int k = 0; k < spline.axes(); ++k) {
        static_cast<void>(spline.axis(k).spans());
    }
}

bool Jet::evaluate(const Spline &given, const AxisRules &rules, const double *param, int order) noexcept {
    const Spline &spline = at_origin(given);
    Series series[2];
    double c = 0;
    const bool surface = spline.axes() == 2;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        if (!fill(spline.axis(k), rules[at], param[k], order, series[k])) {
            return false;
        }
        c += accuracy_factor(spline.axis(k).degree());
        side_[at] = series[k].side;
        unit_[at] = series[k].unit;
    }
    Sums sums = contract(spline, series[0], series[1], order);
    if (spline.rational()) {
        divide(order, surface, spline.dim(), sums);
    }
    for_each_slot(surface ? 2 : 1, order, [&](int i, int j, int) {
        const size_t at = place(i, j);
        values_[at] = vector(sums.values[at], spline.dim());
        errors_[at] = 2 * (c + 2 * (i + j)) * eps * length(vector(sums.sizes[at], spline.dim()));
    });
    return true;
}

} // namespace nrb::eval
