/* SPDX-License-Identifier: MIT */
// Lengths, areas, moments, boxes, cones and extreme points.
#include "recorded/batteries/batteries.h"

#include <cmath>

namespace recorded {

namespace {

void lengths(const Subject &s) {
    const std::vector<double> part = s.range(0.15, 0.65), params = s.params(8);
    for (const double tolerance : {1e-3, 1e-9}) {
        nurbs_curve_length(s.g, nullptr, tolerance, unread, unread);
        nurbs_curve_length(s.g, part.data(), tolerance, unread, unread);
        nurbs_curve_lengths(s.g, 8, params.data(), 0, tolerance, unread, 0);
    }
    const double wanted[] = {0, 0.1 * s.size, 0.3 * s.size, 0.5 * s.size};
    for (const uint32_t flags : {0u, NURBS_CLAMP, NURBS_WRAP}) {
        nurbs_curve_params_at_lengths(s.g, 4, wanted, 0, 1e-9, unread, 0, flags);
    }
    nurbs_curve_divide(s.g, nullptr, 5, 1e-9, 0, unread, unread);
    nurbs_curve_divide(s.g, part.data(), 3, 1e-9, 0, unread, unread);
    if (s.even) { // else the way to a division may be long
        nurbs_curve_divide(s.g, nullptr, 3, 1e-9, NURBS_EQUAL_CHORDS, unread, unread);
    }
}

void contents(const Subject &s) {
    const std::vector<double> part = s.range(0.15, 0.65);
    for (const double tolerance : {1e-1, s.large ? 1e-2 : 1e-5}) {
        nurbs_surface_area(s.g, nullptr, tolerance, unread, unread);
        nurbs_surface_area(s.g, part.data(), tolerance, unread, unread);
        if (s.axes < 3) {
            nurbs_moments(s.g, tolerance, unread, unread, unread, unread);
        }
    }
    nurbs_moments(s.g, s.even ? 1e-1 : 1, unread, unread, nullptr, unread);
    const nurbs *const one[] = {s.g};
    nurbs_enclosed_area(1, one, 10 * s.size, 1e-6, unread, unread, unread, unread);
    nurbs_enclosed_area(1, one, 0, 1e-6, unread, nullptr, nullptr, unread);
    nurbs_enclosed_volume(1, one, s.large ? 1e-2 : 1e-4, unread, unread, unread, unread, unread);
}

void boxes(const Subject &s, const double *range) {
    for (const double tolerance : {1e-1, 1e-6, HUGE_VAL}) {
        nurbs_box(s.g, range, tolerance * s.size, unread, unread, unread);
        for (const int which : {1, 2}) {
            nurbs_extreme_point(s.g, s.direction(which).data(), range, tolerance * s.size, unread, unread,
                                unread);
        }
    }
    for (const double tolerance : {0.3, s.large ? 0.1 : 1e-3}) {
        for (int32_t k = 0; k < s.axes; ++k) {
            nurbs_tangent_cone(s.g, k, range, tolerance, unread, unread);
        }
        nurbs_normal_cone(s.g, range, tolerance, unread, unread);
    }
}

} // namespace

void call_measures(const Subject &s) {
    lengths(s);
    contents(s);
    boxes(s, nullptr);
    boxes(s, s.range(0.3, 0.8).data());
    for (const double tolerance : {1e-3, HUGE_VAL}) {
        nurbs_oriented_box(s.g, tolerance * s.size, unread, unread, unread);
    }
}

} // namespace recorded
