/* SPDX-License-Identifier: MIT */
// Points, derivatives and gradients: lists and grids, packed and with strides, inside the domain and outside.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

constexpr int n = 24;

// One choice of parameters and flags.
void lists(const Subject &s, const std::vector<double> &params, uint32_t flags) {
    const double *const p = params.data();
    nurbs_eval(s.g, n, p, 0, 0, unread, 0, 0, flags);
    nurbs_eval_f32(s.g, n, p, 0, 0, unread, 0, 0, flags);
    nurbs_hull_size(s.g, n, p, 0, 0, unread, 0, flags);
    nurbs_rational_basis(s.g, n, p, 0, 0, unread, unread, 0, 0, flags);
    for (const int32_t order : {0, 1, 2, 3}) {
        nurbs_eval_derivs(s.g, order, n, p, 0, 0, unread, 0, 0, flags);
    }
}

// As columns, and in the rows of a table.
void strides(const Subject &s, const std::vector<double> &params) {
    const double *const p = params.data();
    constexpr int64_t row = 600;
    nurbs_eval(s.g, n, p, 1, n, unread, 1, n, 0);
    nurbs_eval(s.g, n / 4, p, s.axes, 1, unread, row, 1, 0);
    nurbs_eval_f32(s.g, n / 4, p, s.axes, 1, unread, row, 1, 0);
    nurbs_eval_derivs(s.g, 2, n, p, 1, n, unread, 1, n, 0);
    nurbs_eval_derivs(s.g, 1, n / 4, p, s.axes, 1, unread, row, 1, 0);
    nurbs_hull_size(s.g, n / 4, p, s.axes, 1, unread, 2, 0);
}

// One parameter after the other, and more than a few at once.
void sizes_of_batches(const Subject &s) {
    const std::vector<double> params = s.params(150);
    for (int32_t i = 0; i < 5; ++i) {
        nurbs_eval(s.g, 1, params.data() + i * s.axes, 0, 0, unread, 0, 0, 0);
        nurbs_eval_derivs(s.g, 2, 1, params.data() + i * s.axes, 0, 0, unread, 0, 0, 0);
    }
    for (const int64_t size : {2, 3, 5, 8, 17, 150}) {
        nurbs_eval(s.g, size, params.data(), 0, 0, unread, 0, 0, 0);
        nurbs_eval_derivs(s.g, 1, size, params.data(), 0, 0, unread, 0, 0, 0);
    }
    nurbs_eval_derivs(s.g, 6, 3, params.data(), 0, 0, unread, 0, 0, 0);
    nurbs_most_influential(s.g, 150, params.data(), 0, 0, unread, unread);
}

void flags(const Subject &s) {
    const std::vector<double> inside = s.params(n), outside = s.outside(n);
    lists(s, inside, 0);
    lists(s, inside, NURBS_ON_ALL_AXES(s.axes, NURBS_LEFT));
    lists(s, outside, 0);
    for (const uint32_t one :
         {NURBS_CLAMP, NURBS_EXTRAPOLATE, NURBS_WRAP, NURBS_NAN, NURBS_WRAP | NURBS_LEFT | NURBS_NAN}) {
        lists(s, outside, NURBS_ON_ALL_AXES(s.axes, one));
    }
    lists(s, outside, NURBS_ON_AXIS(s.axes - 1, NURBS_CLAMP) | NURBS_NAN);
    strides(s, inside);
}

void grids(const Subject &s) {
    for (const int64_t size : {1, 3, 7}) {
        const int64_t counts[] = {size, size + 1, 2}, total = s.axes == 1   ? size
                                                              : s.axes == 2 ? size * (size + 1)
                                                                            : 2 * size * (size + 1);
        const std::vector<double> params = s.grid(counts);
        for (const uint32_t flag : {0u, NURBS_ON_ALL_AXES(s.axes, NURBS_LEFT)}) {
            nurbs_eval_grid(s.g, counts, params.data(), unread, 0, 0, flag);
            nurbs_eval_grid_f32(s.g, counts, params.data(), unread, 0, 0, flag);
            nurbs_eval_grid_derivs(s.g, 1, counts, params.data(), unread, 0, 0, flag);
            nurbs_eval_grid_derivs(s.g, 3, counts, params.data(), unread, 0, 0, flag);
        }
        nurbs_eval_grid(s.g, counts, params.data(), unread, 1, total, 0);
        nurbs_eval_grid_derivs(s.g, 2, counts, params.data(), unread, 200, 1, 0);
    }
}

// Sums of two calls too.
void gradients(const Subject &s) {
    const std::vector<double> params = s.params(n), cotangents = s.numbers(n * 20 * s.dim);
    std::vector<double> points(static_cast<size_t>(s.points * s.dim)), weights(static_cast<size_t>(s.points)),
        places(static_cast<size_t>(n * s.axes));
    for (const int32_t order : {0, 1, 2}) {
        nurbs_eval_adjoint(s.g, order, n, params.data(), 0, 0, cotangents.data(), 0, 0, points.data(), 0, 0,
                           weights.data(), 0, places.data(), 0, 0, 0);
        nurbs_eval_adjoint(s.g, order, n / 2, params.data(), 0, 0, cotangents.data(), 0, 0, points.data(), 0,
                           0, weights.data(), 0, places.data(), 0, 0, NURBS_ACCUMULATE);
    }
    nurbs_eval_adjoint(s.g, 1, n, s.outside(n).data(), 0, 0, cotangents.data(), 0, 0, points.data(), 1,
                       s.points, nullptr, 0, nullptr, 0, 0, NURBS_ON_ALL_AXES(s.axes, NURBS_CLAMP));
}

void iso_and_polar(const Subject &s) {
    for (int32_t k = 0; k < s.axes; ++k) {
        for (const double fraction : {0.0, 0.3, 0.5, 1.0}) {
            nurbs_iso(s.g, k, s.at(k, fraction), 0, unread);
            nurbs_iso(s.g, k, s.at(k, fraction), NURBS_LEFT, unread);
        }
        nurbs_iso(s.g, k, 2 * s.at(k, 1) - s.at(k, 0.9), NURBS_EXTRAPOLATE, unread);
    }
    std::vector<double> arguments;
    for (int32_t k = 0; k < s.axes; ++k) {
        for (int32_t i = 0; i < s.axis[static_cast<size_t>(k)].degree; ++i) {
            arguments.push_back(s.at(k, 0.1 * i));
        }
    }
    nurbs_blossom(s.g, s.middle(0.4).data(), static_cast<int64_t>(arguments.size()), arguments.data(), unread,
                  0);
    nurbs_blossom(s.g, s.middle(1).data(), static_cast<int64_t>(arguments.size()), arguments.data(), unread,
                  NURBS_ON_ALL_AXES(s.axes, NURBS_LEFT));
}

} // namespace

void call_points(const Subject &s) {
    flags(s);
    sizes_of_batches(s);
    grids(s);
    gradients(s);
    iso_and_polar(s);
}

} // namespace recorded
