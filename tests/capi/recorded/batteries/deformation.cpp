/* SPDX-License-Identifier: MIT */
// Shapes that are changed: by constraints, in a region, as a whole, and to join others.
#include "recorded/batteries/batteries.h"

#include <cmath>

namespace recorded {

namespace {

constexpr double loose = 1e-2;

// Points that go elsewhere; with them what stays at the ends, and weights that may change.
void constrain_points(const Subject &s) {
    const std::vector<double> params = s.params(2), targets = s.near(2);
    const std::vector<double> costs(static_cast<size_t>(s.points), 1.5);
    const int32_t keep[] = {0, 0, -1, 0, -1, -1};
    nurbs_constrain(s.g, 1, nullptr, nullptr, params.data(), targets.data(), nullptr, nullptr, nullptr, 0,
                    unread, unread, unread, unread, unread);
    nurbs_constrain(s.g, 2, nullptr, nullptr, params.data(), targets.data(), keep, costs.data(), nullptr,
                    loose * s.size, unread, unread, unread, unread, unread);
    if (s.points <= 60) {
        nurbs_constrain(s.g, 1, nullptr, nullptr, params.data(), targets.data(), nullptr, costs.data(),
                        costs.data(), loose * s.size, unread, unread, unread, unread, unread);
    }
}

void constrain_others(const Subject &s) {
    const std::vector<double> params = s.middle(0.4), target = s.direction(4);
    const int32_t orders[] = {1, 0, 0};
    for (const int32_t kind : {NURBS_CONSTRAIN_VALUE, NURBS_CONSTRAIN_DIRECTION}) {
        nurbs_constrain(s.g, 1, &kind, orders, params.data(), target.data(), nullptr, nullptr, nullptr, 0,
                        unread, unread, unread, unread, unread);
    }
    for (const int32_t kind : {NURBS_CONSTRAIN_NORMAL, NURBS_CONSTRAIN_CURVATURE}) {
        nurbs_constrain(s.g, 1, &kind, nullptr, params.data(), target.data(), nullptr, nullptr, nullptr,
                        loose, unread, unread, unread, unread, unread);
    }
}

void regions(const Subject &s) {
    const std::vector<double> part = s.range(0.3, 0.7), direction = s.direction(2), normal = s.direction(3);
    for (const double *const range : {static_cast<const double *>(nullptr), part.data()}) {
        for (const int32_t order : {0, 2}) {
            nurbs_warp(s.g, range, direction.data(), 0.1 * s.size, order, unread);
        }
        nurbs_flatten(s.g, range, s.center.data(), normal.data(), nullptr, unread, unread);
        nurbs_flatten(s.g, range, s.center.data(), normal.data(), direction.data(), unread, unread);
    }
}

void bend(const Subject &s) {
    const std::vector<double> along = s.direction(5), across = s.direction(6);
    const double tolerance = (s.axes == 1 ? 1e-2 : 0.2) * s.size;
    nurbs_bend(s.g, s.center.data(), along.data(), across.data(), 0.3 / s.size, -HUGE_VAL, HUGE_VAL,
               tolerance, unread, unread, unread);
    nurbs_bend(s.g, s.center.data(), along.data(), across.data(), 0.8 / s.size, -0.1 * s.size, 0.2 * s.size,
               5 * tolerance, unread, unread, unread);
}

// By a block of twice the size with one corner pulled.
void free_form(const Subject &s) {
    const int32_t degrees[] = {1, 2, 1};
    std::vector<double> points, lower, upper;
    const int32_t total = s.dim == 1 ? 2 : s.dim == 2 ? 6 : 12;
    for (int32_t i = 0; i < total; ++i) {
        const int32_t first = s.dim == 1   ? i
                              : s.dim == 2 ? i / 3
                                           : i / 6,
                      second = s.dim == 2 ? i % 3 : i / 2 % 3;
        const double place[] = {static_cast<double>(first), second / 2.0, static_cast<double>(i % 2)};
        points.insert(points.end(), place, place + s.dim);
    }
    points.back() += 0.25;
    for (const double x : s.center) {
        lower.push_back(x - s.size);
        upper.push_back(x + s.size);
    }
    Owned block;
    nurbs_create_bezier(s.dim, degrees, s.dim, points.data(), 0, 0, nullptr, 0, block.place());
    if (block != nullptr) {
        nurbs_free_form_deform(s.g, block, lower.data(), upper.data(), loose, unread, unread, unread);
    }
}

void fair(const Subject &s) {
    const int32_t free_ends[] = {-1, -1, -1, -1, -1, -1};
    if (s.large) {
        nurbs_fair(s.g, 2, nullptr, 10 * s.size, unread, unread, unread);
        return;
    }
    for (const int32_t order : {1, 2, 3}) {
        nurbs_fair(s.g, order, nullptr, loose * s.size, unread, unread, unread);
        nurbs_fair(s.g, order, free_ends, 10 * s.size, unread, unread, unread);
    }
}

void snap(const Subject &s, int32_t k) {
    for (const nurbs *other : {static_cast<const nurbs *>(s.image), static_cast<const nurbs *>(s.part)}) {
        for (int32_t order = 0; other != nullptr && order <= 1; ++order) {
            nurbs_snap_boundary(s.g, k, NURBS_END, other, k, NURBS_START, order, 0, unread, unread);
            nurbs_snap_boundary(s.g, k, NURBS_START, other, s.large ? k : s.axes - 1 - k, NURBS_START, order,
                                NURBS_REVERSED, unread, unread);
        }
    }
}

} // namespace

void call_deformation(const Subject &s) {
    constrain_points(s);
    constrain_others(s);
    regions(s);
    if (s.axes == 1 || s.even) { // uneven weights ask for very many control points
        bend(s);
    }
    if (s.dim <= NURBS_MAX_AXES && (s.axes == 1 || s.even)) {
        free_form(s);
    }
    fair(s);
    for (int32_t k = 0; k < s.axes; ++k) {
        snap(s, k);
    }
}

} // namespace recorded
