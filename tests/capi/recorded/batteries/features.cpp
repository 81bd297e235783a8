/* SPDX-License-Identifier: MIT */
// What happens on a shape, what it is, and how smooth it is.
#include "recorded/batteries/batteries.h"

#include <cmath>

namespace recorded {

namespace {

void curves(const Subject &s) {
    constexpr int64_t cap = 4000;
    for (const uint32_t kinds : {0x3fu, 0x7fu, 0x10u}) {
        nurbs_curve_features(s.g, kinds, cap, unread, unread, unread, unread, unread);
    }
    nurbs_curve_features(s.g, 0x3f, 0, nullptr, nullptr, nullptr, unread, nullptr);
    for (const int which : {1, 2}) {
        nurbs_curve_monotone_pieces(s.g, s.direction(which).data(), cap, unread, unread, unread, unread);
    }
    nurbs_curve_convexity(s.g, unread);
    nurbs_curve_shape_factor(s.g, unread, unread);
}

void flatness(const Subject &s) {
    nurbs_straightness(s.g, unread, unread, unread);
    nurbs_planarity(s.g, unread, unread, unread);
    for (const double tolerance : {0.0, 1e-6, 0.1}) {
        nurbs_boundary_contacts(s.g, tolerance * s.size, unread, unread, unread, unread);
    }
    for (const double tolerance : {1e-9, 1e-3, 0.5}) {
        nurbs_recognize(s.g, tolerance * s.size, unread, unread, unread, unread);
    }
}

void singularities(const Subject &s) {
    constexpr int64_t cap = 20000;
    for (const double tolerance : {0.1, s.large ? 0.05 : 0.01}) {
        nurbs_singular_points(s.g, tolerance, cap, unread, unread, unread, unread);
    }
    nurbs_fold_test(s.g, nullptr, unread, unread, unread);
    if (!s.large) {
        nurbs_fold_test(s.g, s.direction(3, 3).data(), unread, unread, unread);
    }
}

void smoothness(const Subject &s, int32_t k) {
    const int64_t cap = s.axis[static_cast<size_t>(k)].count + 2;
    for (const double tolerance : {0.0, 1e-6, HUGE_VAL}) {
        nurbs_continuity(s.g, k, tolerance * s.size, tolerance, tolerance, cap, unread, unread, unread,
                         unread, unread, unread, unread, unread);
    }
}

// Where the end of one curve meets the other; not at all if it is not moved there.
void meetings(const Subject &s, const nurbs *other) {
    for (const int32_t end : {NURBS_START, NURBS_END}) {
        for (const int32_t start : {NURBS_START, NURBS_END}) {
            nurbs_continuity_between(s.g, end, other, start, 1e-6 * s.size, 1e-6, 1e-6, unread, unread,
                                     unread, unread, unread);
        }
    }
}

} // namespace

void call_features(const Subject &s) {
    curves(s);
    flatness(s);
    singularities(s);
    for (int32_t k = 0; k < s.axes; ++k) {
        smoothness(s, k);
    }
    meetings(s, s.g);
    if (s.image != nullptr) {
        meetings(s, s.image);
    }
}

} // namespace recorded
