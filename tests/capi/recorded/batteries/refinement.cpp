/* SPDX-License-Identifier: MIT */
// Knots that go in, parts and ends.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

void insert(const Subject &s, int32_t k) {
    const AxisFacts &a = s.axis[static_cast<size_t>(k)];
    for (const double fraction : {0.0, 0.35, 0.7, 1.0}) {
        for (const int32_t times : {0, 1, 2, a.degree, a.degree + 1}) {
            nurbs_insert_knot(s.g, k, s.at(k, fraction), times, unread);
        }
    }
    nurbs_insert_knot(s.g, k, a.knots[a.knots.size() / 2], 1, unread);
    const std::vector<double> knots = {s.at(k, 0.1), s.at(k, 0.15), s.at(k, 0.15), s.at(k, 0.6),
                                       s.at(k, 0.9)};
    for (const int64_t count : {1, 2, 3, 5}) {
        nurbs_refine(s.g, k, count, knots.data(), unread);
    }
    for (const int64_t parts : {1, 2, 5}) {
        nurbs_refine_uniform(s.g, k, parts, unread);
    }
}

void insert_on_polygon(const Subject &s, int32_t k) {
    const AxisFacts &a = s.axis[static_cast<size_t>(k)];
    for (const int64_t index : {int64_t{0}, a.count / 2, a.count - 2}) {
        for (const double ratio : {0.0, 0.4, 1.0}) {
            nurbs_insert_on_leg(s.g, k, index, ratio, unread, unread);
        }
    }
    nurbs_insert_at_point(s.g, k, s.center.data(), 10 * s.size, unread, unread, unread, unread);
    nurbs_insert_at_point(s.g, k, s.control.data(), 1e-9 * s.size, unread, unread, unread, unread);
}

void cut(const Subject &s, int32_t k) {
    for (const double fraction : {0.0, 0.25, 0.8}) {
        nurbs_split(s.g, k, s.at(k, fraction), unread, unread);
    }
    for (const int32_t order : {0, 1, 2, 40}) {
        nurbs_split_at_knots(s.g, k, order, unread);
    }
}

void ends(const Subject &s, int32_t k) {
    for (const uint32_t flags : {1u, 2u, 3u}) {
        nurbs_clamp_ends(s.g, k, flags, unread);
        nurbs_unclamp(s.g, k, flags, unread);
        nurbs_unclamp(s.g, k, flags | NURBS_HOMOGENEOUS, unread);
    }
    const double width = s.at(k, 1) - s.at(k, 0);
    for (const int32_t end : {NURBS_START, NURBS_END}) {
        for (const int32_t order : {0, 1, 2, 20}) {
            nurbs_extend(s.g, k, end, 0.1 * width, order, unread);
        }
        nurbs_extend(s.g, k, end, 5 * width, 1, unread);
    }
}

void seams(const Subject &s, int32_t k) {
    for (const double fraction : {0.0, 0.3, 0.75}) {
        nurbs_move_seam(s.g, k, s.at(k, fraction), unread);
    }
    for (const double tolerance : {0.0, 1e-6, 10.0}) {
        nurbs_make_periodic(s.g, k, tolerance * s.size, unread, unread, unread);
    }
}

// Both halves together again, and pieces that do not meet.
void join(const Subject &s, int32_t k) {
    Owned lower, upper;
    nurbs_split(s.g, k, s.at(k, 0.4), lower.place(), upper.place());
    if (lower == nullptr || upper == nullptr) {
        return;
    }
    const nurbs *const parts[] = {lower, upper}, *const apart[] = {upper, lower, s.image};
    nurbs_join(2, parts, k, 1e-6 * s.size, 0, unread, unread);
    nurbs_join(2, parts, k, 0, 0, unread, unread);
    nurbs_join(2, apart, k, 10 * s.size, 0, unread, unread);
    nurbs_join(s.image == nullptr ? 2 : 3, apart, k, 0, NURBS_KEEP_GAPS, unread, unread);
}

} // namespace

void call_refinement(const Subject &s) {
    for (int32_t k = 0; k < s.axes; ++k) {
        insert(s, k);
        insert_on_polygon(s, k);
        cut(s, k);
        ends(s, k);
        seams(s, k);
        join(s, k);
    }
    nurbs_decompose(s.g, unread);
    int64_t pieces = 0;
    if (nurbs_bezier_pieces(s.g, 0, nullptr, nullptr, nullptr, nullptr, &pieces) == NURBS_OK) {
        nurbs_bezier_pieces(s.g, pieces, unread, unread, unread, unread, unread);
    }
    std::vector<double> lower = s.middle(0.2), upper = s.middle(0.9);
    nurbs_extract(s.g, lower.data(), upper.data(), unread);
    lower[0] = s.at(0, 0);
    nurbs_extract(s.g, lower.data(), upper.data(), unread);
    upper[0] = s.at(0, 0);
    nurbs_extract(s.g, lower.data(), upper.data(), unread);
    upper[0] = s.at(0, 1) + (s.at(0, 1) - s.at(0, 0)) / 4; // around the seam of a loop
    nurbs_extract(s.g, s.middle(0.5).data(), upper.data(), unread);
}

} // namespace recorded
