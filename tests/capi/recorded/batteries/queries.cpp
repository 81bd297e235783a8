/* SPDX-License-Identifier: MIT */
// Nearest and farthest points, and distances of splines, with budgets that end and those of the library.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

constexpr int n = 6;

struct Search {
    double tolerance; // as a part of the size
    int64_t budget;
};
constexpr Search searches[] = {{1e-3, 0}, {1e-9, 40}, {0, 150}};

void nearest(const Subject &s, const std::vector<double> &points, const Search &search) {
    const double tolerance = search.tolerance * s.size;
    const std::vector<double> part = s.range(0.2, 0.7);
    for (const double *const range : {static_cast<const double *>(nullptr), part.data()}) {
        nurbs_closest_points(s.g, n, points.data(), 0, 0, range, tolerance, search.budget, unread, 0, 0,
                             unread, 0, 0, unread, 0, unread, 0);
        nurbs_farthest_points(s.g, n, points.data(), 0, 0, range, tolerance, search.budget, unread, 0, 0,
                              unread, 0, 0, unread, 0, unread, 0);
    }
    nurbs_closest_points(s.g, n / 2, points.data(), 0, 0, nullptr, tolerance, search.budget, unread, 1, n,
                         nullptr, 0, 0, nullptr, 0, nullptr, NURBS_NAN_POINTS);
    nurbs_curve_signed_distances(s.g, n, points.data(), 0, 0, tolerance, search.budget, unread, 0, unread, 0,
                                 unread, 0);
}

void all_points(const Subject &s, const double *point, const Search &search) {
    const double tolerance = search.tolerance * s.size;
    const std::vector<double> part = s.range(0.1, 0.6);
    constexpr int64_t cap = 4000;
    for (const double *const range : {static_cast<const double *>(nullptr), part.data()}) {
        nurbs_closest_all(s.g, point, range, tolerance, search.budget, cap, unread, unread, unread, unread);
        nurbs_critical_points(s.g, point, range, tolerance, search.budget, cap, unread, unread, unread,
                              unread, unread);
    }
}

void distances(const Subject &s, const nurbs *other, double tolerance, int64_t budget) {
    if (other == nullptr) {
        return;
    }
    nurbs_distance(s.g, other, tolerance * s.size, budget, unread, unread, unread, unread, unread);
    nurbs_distance(other, s.g, tolerance * s.size, budget, unread, unread, unread, unread, unread);
    nurbs_hausdorff_distance(s.g, other, tolerance * s.size, budget, unread, unread, unread, unread, unread);
}

// Points of the spline itself among the others.
std::vector<double> query_points(const Subject &s) {
    std::vector<double> points = s.near(n), own(static_cast<size_t>(2 * s.dim));
    const std::vector<double> params = s.params(2);
    if (nurbs_eval(s.g, 2, params.data(), 0, 0, own.data(), 0, 0, 0) == NURBS_OK) {
        std::copy(own.begin(), own.end(), points.begin());
    }
    return points;
}

} // namespace

void call_closest(const Subject &s) {
    const std::vector<double> points = query_points(s);
    for (const Search &search : searches) {
        nearest(s, points, search);
        all_points(s, points.data() + 3 * s.dim, search);
    }
    nurbs_closest_local(s.g, n, points.data(), 0, 0, s.params(n).data(), 0, 0, unread, 0, 0, unread, 0, 0,
                        unread, 0, unread, 0);
}

// The library's budgets are for curves: surfaces and volumes may take seconds.
void call_distances(const Subject &s) {
    for (const nurbs *other : {static_cast<const nurbs *>(s.image), static_cast<const nurbs *>(s.part)}) {
        distances(s, other, 1e-2, s.axes == 1 ? 0 : s.axes == 2 ? 300 : 60);
        if (s.axes < 3) {
            distances(s, other, 1e-6, 60);
        }
    }
    distances(s, s.g, 0, 100);
}

} // namespace recorded
