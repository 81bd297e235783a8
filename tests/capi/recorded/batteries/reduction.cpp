/* SPDX-License-Identifier: MIT */
// Knots and degrees that go, and splines that are brought to one form.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

constexpr double tolerances[] = {0, 1e-9, 1e-2, 10};

void remove(const Subject &s, int32_t k) {
    const AxisFacts &a = s.axis[static_cast<size_t>(k)];
    const double inside = a.knots[a.knots.size() / 2];
    for (const double tolerance : tolerances) {
        nurbs_remove_knot(s.g, k, inside, 1, tolerance * s.size, unread, unread, unread);
        nurbs_remove_knot(s.g, k, inside, 40, tolerance * s.size, unread, unread, unread);
        nurbs_reduce_knots(s.g, k, tolerance * s.size, unread, unread);
    }
    nurbs_remove_knot(s.g, k, s.at(k, 0), 1, s.size, unread, unread, unread);
}

// What was put in goes again.
void put_in_and_remove(const Subject &s, int32_t k) {
    Owned more, higher;
    nurbs_insert_knot(s.g, k, s.at(k, 0.37), 1, more.place());
    nurbs_elevate(s.g, k, 1, higher.place());
    if (more != nullptr) {
        nurbs_remove_knot(more, k, s.at(k, 0.37), 1, 1e-9 * s.size, unread, unread, unread);
        nurbs_reduce_knots(more, k, 1e-9 * s.size, unread, unread);
        nurbs_deviation(s.g, more, unread, unread);
    }
    if (higher != nullptr) {
        nurbs_reduce_degree(higher, k, 1, unread, unread);
        nurbs_simplify(higher, 1e-9 * s.size, unread, unread);
    }
}

void lower(const Subject &s, int32_t k) {
    for (const int32_t times : {0, 1, 2}) {
        nurbs_reduce_degree(s.g, k, times, unread, unread);
    }
    for (const double tolerance : {0.0, 1e-3, 0.3}) {
        nurbs_snap_knots(s.g, k, tolerance, unread, unread);
    }
}

void compatible(const Subject &s, const nurbs *other) {
    if (other == nullptr) {
        return;
    }
    const nurbs *const both[] = {s.g, other};
    for (const uint32_t flags : {0u, NURBS_MAP_DOMAINS}) {
        for (const double tolerance : {0.0, 0.01}) {
            nurbs_make_compatible(2, both, tolerance, flags, unread, unread);
        }
    }
}

} // namespace

void call_reduction(const Subject &s) {
    for (int32_t k = 0; k < s.axes; ++k) {
        remove(s, k);
        put_in_and_remove(s, k);
        lower(s, k);
    }
    for (const double tolerance : tolerances) {
        nurbs_reduce_knots(s.g, -1, tolerance * s.size, unread, unread);
        if (!s.large || tolerance == 1e-2) {
            nurbs_simplify(s.g, tolerance * s.size, unread, unread);
        }
    }
    if (s.image != nullptr) {
        nurbs_deviation(s.g, s.image, unread, unread);
    }
    nurbs_deviation(s.g, s.g, unread, unread);
    compatible(s, s.image);
    compatible(s, s.part);
}

} // namespace recorded
