/* SPDX-License-Identifier: MIT */
// Surfaces and volumes that a spline begins, and those that its own boundaries bring forth again.
#include "recorded/batteries/batteries.h"

#include <cmath>

namespace recorded {

namespace {

void sweeps(const Subject &s) {
    const std::vector<double> vector = s.direction(7), axis = s.direction(8, 3), point = s.direction(9, 3);
    nurbs_extrude(s.g, vector.data(), unread);
    for (const int32_t form : {NURBS_ARC_QUARTERS, NURBS_ARC_THIRDS, NURBS_ARC_SMOOTH}) {
        nurbs_revolve(s.g, nullptr, nullptr, 2, form, unread);
        nurbs_revolve(s.g, point.data(), axis.data(), std::acos(-1) * 2, form, unread);
    }
    for (const nurbs *other : {static_cast<const nurbs *>(s.image), static_cast<const nurbs *>(s.part)}) {
        if (other != nullptr) {
            nurbs_ruled(s.g, other, 0, unread);
            nurbs_ruled(s.g, other, NURBS_RULED_CARTESIAN, unread);
            nurbs_surface_swung(s.g, other, 0.7, unread);
        }
    }
}

std::vector<Owned> boundaries(const Subject &s) {
    nurbs_list *list = nullptr;
    int64_t count = 0;
    std::vector<Owned> parts;
    if (nurbs_boundaries(s.g, &list) == NURBS_OK) {
        nurbs_list_count(list, &count);
    }
    for (int64_t i = 0; i < count; ++i) {
        nurbs_list_get(list, i, parts.emplace_back().place());
    }
    nurbs_list_destroy(list);
    return parts;
}

// The derivatives across the boundaries of a surface, that they begin with.
std::vector<Owned> cross_tangents(const Subject &s) {
    std::vector<Owned> all;
    for (const int32_t k : {0, 1}) {
        Owned slope;
        nurbs_derivative(s.g, k, 1, slope.place());
        for (const double end : {0.0, 1.0}) {
            Owned &curve = all.emplace_back();
            if (slope != nullptr) {
                nurbs_iso(slope, k, s.at(k, end), end == 1 ? NURBS_LEFT : 0, curve.place());
            }
        }
    }
    return all;
}

std::vector<const nurbs *> places(const std::vector<Owned> &all) {
    return {all.begin(), all.end()};
}

bool complete(const std::vector<const nurbs *> &all) {
    return std::find(all.begin(), all.end(), nullptr) == all.end();
}

void surface_blends(const Subject &s, const std::vector<const nurbs *> &edges) {
    const std::vector<Owned> slopes = cross_tangents(s);
    const std::vector<const nurbs *> cross = places(slopes);
    const std::vector<double> twists = s.numbers(4 * s.dim);
    const double gap = 1e-6 * s.size;
    nurbs_surface_coons(edges.data(), gap, unread);
    nurbs_coons_gaps(edges.data(), nullptr, unread, unread, unread);
    for (const int32_t twist : {NURBS_TWIST_ZERO, NURBS_TWIST_BILINEAR, NURBS_TWIST_ADINI}) {
        nurbs_surface_coons_hermite(edges.data(), nullptr, twist, nullptr, gap, unread, unread);
    }
    nurbs_surface_coons_hermite(edges.data(), nullptr, NURBS_TWIST_GIVEN, twists.data(), gap, unread, unread);
    if (!complete(cross)) {
        return;
    }
    nurbs_coons_gaps(edges.data(), cross.data(), unread, unread, unread);
    for (const int32_t twist : {NURBS_TWIST_COMPATIBLE, NURBS_TWIST_AVERAGE, NURBS_TWIST_ADINI}) {
        nurbs_surface_coons_hermite(edges.data(), cross.data(), twist, nullptr, 1e-3 * s.size, unread,
                                    unread);
    }
}

void blends(const Subject &s) {
    const std::vector<Owned> parts = boundaries(s);
    const std::vector<const nurbs *> all = places(parts);
    if (all.size() == 4 && complete(all)) {
        surface_blends(s, all);
    }
    if (all.size() == 6 && complete(all)) {
        if (s.even) { // else the bounds of gaps take seconds
            nurbs_volume_coons(all.data(), 1e-6 * s.size, unread);
        }
        nurbs_enclosed_volume(6, all.data(), 1e-4, unread, unread, unread, unread, unread);
    }
}

} // namespace

void call_shapes(const Subject &s) {
    sweeps(s);
    blends(s);
}

} // namespace recorded
