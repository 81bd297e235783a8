/* SPDX-License-Identifier: MIT */
// Frames, normals and curvatures of curves and surfaces.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

constexpr int n = 20;

void surfaces(const Subject &s, const std::vector<double> &params, uint32_t flags) {
    const double *const p = params.data();
    nurbs_surface_eval_frames(s.g, n, p, 0, 0, unread, 0, 0, unread, 0, 0, unread, 0, 0, unread, 0, 0, unread,
                              flags);
    nurbs_surface_eval_frames(s.g, n, p, 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0, unread, 1, n,
                              nullptr, flags);
    nurbs_surface_eval_curvatures(s.g, n, p, 0, 0, unread, 0, 0, unread, 0, 0, unread, 0, unread, 0, unread,
                                  flags);
    nurbs_surface_eval_curvatures(s.g, n, p, 0, 0, nullptr, 0, 0, nullptr, 0, 0, unread, 3, nullptr, 0,
                                  nullptr, flags);
}

void grids(const Subject &s) {
    const int64_t counts[] = {5, 4, 3};
    const std::vector<double> params = s.grid(counts);
    for (const uint32_t flags : {0u, NURBS_ON_ALL_AXES(s.axes, NURBS_LEFT)}) {
        nurbs_surface_eval_grid_frames(s.g, counts, params.data(), unread, 0, 0, unread, 0, 0, unread, 0, 0,
                                       unread, 0, 0, unread, flags);
    }
}

void curves(const Subject &s, const std::vector<double> &params, uint32_t flags) {
    const double *const p = params.data();
    nurbs_curve_eval_frames(s.g, n, p, 0, unread, 0, 0, unread, 0, 0, unread, 0, 0, nullptr, 0, 0, unread, 0,
                            nullptr, 0, unread, flags);
    nurbs_curve_eval_frames(s.g, n, p, 0, unread, 0, 0, unread, 0, 0, unread, 0, 0, unread, 0, 0, unread, 0,
                            unread, 0, unread, flags);
    nurbs_curve_eval_frames(s.g, n, p, 0, nullptr, 0, 0, unread, 1, n, nullptr, 0, 0, nullptr, 0, 0, nullptr,
                            0, nullptr, 0, nullptr, flags);
}

void rotation_minimizing(const Subject &s) {
    const std::vector<double> first = s.direction(1, 3), params = s.params(n);
    for (const double *const normal : {first.data(), static_cast<const double *>(nullptr)}) {
        nurbs_curve_rotation_minimizing_frames(s.g, n, params.data(), 0, normal, unread, 0, 0, unread, 0, 0,
                                               unread, 0, 0, unread, 0, 0, unread, 0);
    }
}

} // namespace

void call_frames(const Subject &s) {
    const std::vector<double> inside = s.params(n), outside = s.outside(n);
    for (const uint32_t flags : {0u, NURBS_ON_ALL_AXES(s.axes, NURBS_LEFT)}) {
        surfaces(s, inside, flags);
        curves(s, inside, flags);
    }
    for (const uint32_t flag : {NURBS_CLAMP | NURBS_NAN, NURBS_EXTRAPOLATE, NURBS_WRAP}) {
        surfaces(s, outside, NURBS_ON_ALL_AXES(s.axes, flag));
        curves(s, outside, NURBS_ON_ALL_AXES(s.axes, flag));
    }
    grids(s);
    rotation_minimizing(s);
}

} // namespace recorded
