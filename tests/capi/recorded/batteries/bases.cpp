/* SPDX-License-Identifier: MIT */
// The questions that every handle answers, its basis functions, and matrices of them.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

constexpr int n = 20;

void axis_questions(const Subject &s, int32_t k) {
    const AxisFacts &a = s.axis[static_cast<size_t>(k)];
    const auto knot_count = static_cast<int64_t>(a.knots.size());
    nurbs_degree(s.g, k, unread);
    nurbs_count(s.g, k, unread);
    nurbs_knots(s.g, k, knot_count, unread);
    nurbs_distinct_knots(s.g, k, knot_count, unread, unread, unread);
    nurbs_distinct_knots(s.g, k, 0, nullptr, nullptr, unread);
    nurbs_knot_form(s.g, k, unread);
    nurbs_domain(s.g, k, unread);
    nurbs_greville(s.g, k, a.count, unread);
    nurbs_detect_periodic(s.g, k, unread);
}

void functions_of_axis(const Subject &s, int32_t k) {
    const AxisFacts &a = s.axis[static_cast<size_t>(k)];
    const auto knot_count = static_cast<int64_t>(a.knots.size());
    const std::vector<double> params = s.params(n);
    const double *const p = params.data() + k;
    for (const uint32_t flags : {0u, NURBS_LEFT}) {
        nurbs_find_spans(a.degree, a.count, a.knots.data(), knot_count, n, p, s.axes, unread, flags);
        for (const int32_t order : {0, 1, 3}) {
            nurbs_basis(a.degree, a.count, a.knots.data(), knot_count, order, n, p, s.axes, unread, unread, 0,
                        0, flags);
        }
    }
    nurbs_basis(a.degree, a.count, a.knots.data(), knot_count, 1, n, s.outside(n).data() + k, s.axes, nullptr,
                unread, 1, n, NURBS_EXTRAPOLATE | NURBS_NAN);
    const std::vector<double> unit = s.numbers(n);
    nurbs_bernstein(a.degree, 2, n, unit.data(), 0, unread, 0, 0);
}

void matrices_of_axis(const Subject &s, int32_t k) {
    const AxisFacts &a = s.axis[static_cast<size_t>(k)];
    nurbs_bezier_extraction(s.g, k, a.count, unread, unread, unread, unread);
    nurbs_bezier_extraction(s.g, k, 0, nullptr, nullptr, nullptr, unread);
    const double knots[] = {s.at(k, 0.2), s.at(k, 0.7)};
    const int64_t cap = (a.count + 2) * (a.degree + 2) * 4;
    nurbs_refinement_matrix(s.g, k, 2, knots, cap, unread, unread, unread, unread);
    for (int32_t from = NURBS_BASIS_POWER; from <= NURBS_BASIS_BSPLINE; ++from) {
        for (int32_t to = NURBS_BASIS_POWER; to <= NURBS_BASIS_BSPLINE; ++to) {
            nurbs_basis_matrix(from, to, a.degree, (a.degree + 1) * (a.degree + 1), unread);
        }
    }
}

void collocation(const Subject &s, const int32_t *orders) {
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<double> knots;
    int64_t row = 1;
    for (const AxisFacts &a : s.axis) {
        degrees.push_back(a.degree);
        counts.push_back(a.count);
        knots.insert(knots.end(), a.knots.begin(), a.knots.end());
        row *= a.degree + 1;
    }
    const std::vector<double> params = s.params(n);
    nurbs_collocation(s.axes, degrees.data(), counts.data(), knots.data(), static_cast<int64_t>(knots.size()),
                      orders, n, params.data(), 0, 0, n * row, unread, unread, unread, unread, 0);
    nurbs_rational_collocation(s.g, orders, n, params.data(), 0, 0, n * row, unread, unread, unread, unread,
                               0);
    nurbs_rational_collocation(s.g, orders, n, params.data(), 0, 0, n * row, unread, nullptr, nullptr,
                               nullptr, NURBS_ON_ALL_AXES(s.axes, NURBS_LEFT));
}

} // namespace

void call_getters(const Subject &s) {
    nurbs_clone(s.g, unread);
    nurbs_axes(s.g, unread);
    nurbs_dimension(s.g, unread);
    nurbs_point_count(s.g, unread);
    nurbs_is_rational(s.g, unread);
    nurbs_is_homogeneous(s.g, unread);
    nurbs_points(s.g, s.points, unread, 0, 0);
    nurbs_points(s.g, s.points, unread, 1, s.points);
    nurbs_weights(s.g, s.points, unread, 2);
    nurbs_homogeneous_points(s.g, s.points, unread, 0, 0);
    nurbs_homogeneous_points(s.g, s.points, unread, s.dim + 4, 1);
    for (int32_t k = 0; k <= s.axes; ++k) { // that behind the last one is refused
        nurbs_degree(s.g, k, unread);
    }
    for (int32_t k = 0; k < s.axes; ++k) {
        axis_questions(s, k);
    }
}

void call_bases(const Subject &s) {
    for (int32_t k = 0; k < s.axes; ++k) {
        functions_of_axis(s, k);
        matrices_of_axis(s, k);
    }
    const int32_t first[] = {1, 0, 0}, mixed[] = {2, 1, 1};
    collocation(s, nullptr);
    collocation(s, first);
    collocation(s, mixed);
}

} // namespace recorded
