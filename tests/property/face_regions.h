// Faces that lie on each other, through the C interface, for tests.
#pragma once

#include "face_meets.h"
#include "overlap_regions.h"

namespace face_regions {

using namespace surface_overlaps;
using support::models::Face;

inline Overlap regions_of(const nurbs_face *a, const nurbs_face *b, double tolerance,
                          const nurbs_call_options *call = nullptr) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_face_intersections_with(a, b, tolerance, call, &meet));
    return overlap_in(MeetHandle(meet).get());
}

inline double length_of(const Overlap &overlap, int32_t kind) {
    double length = 0;
    for (size_t i = 0; i < overlap.crossing.kinds.size(); ++i) {
        double own = 0;
        require_ok(
            nurbs_curve_length(overlap.crossing.found.branches[i].space.get(), nullptr, 1e-9, &own, nullptr));
        length += overlap.crossing.kinds[i] == kind ? own : 0;
    }
    return length;
}

inline Handle surface_of(const nurbs_face *face) {
    return made([&](nurbs **out) { return nurbs_face_surface(face, out); });
}

inline int32_t side_of(const nurbs_face *face, const Place &at, double tolerance) {
    int32_t side = -2;
    require_ok(nurbs_face_classify(face, 1, at.data(), 0, 0, tolerance, &side));
    return side;
}

// On which side of a face a point is that is on it, or not.
inline int32_t side_of(const nurbs_face *face, const nurbs *surface, const Point3 &x, double tolerance) {
    Place at{};
    double distance = -1;
    require_ok(nurbs_closest_points(surface, 1, x.data(), 0, 0, nullptr, 0, 0, at.data(), 0, 0, nullptr, 0, 0,
                                    &distance, 0, nullptr, 0));
    return distance > tolerance ? -1 : side_of(face, at, tolerance);
}

// Places of a are in one region if they are in both faces, and in none otherwise, but for those next to borders.
inline void check_places(const Overlap &overlap, const nurbs_face *a, const nurbs_face *b, double tolerance,
                         int n) {
    const Handle on_a = surface_of(a), on_b = surface_of(b);
    double domain[2][2];
    require_ok(nurbs_domain(on_a.get(), 0, domain[0]));
    require_ok(nurbs_domain(on_a.get(), 1, domain[1]));
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Place at{domain[0][0] + (domain[0][1] - domain[0][0]) * (i + 0.437) / n,
                           domain[1][0] + (domain[1][1] - domain[1][0]) * (j + 0.561) / n};
            const int32_t first = side_of(a, at, tolerance),
                          second = side_of(b, on_b.get(), points_of(on_a.get(), {at})[0], tolerance);
            int turns = 0;
            for (const Region &region : overlap.regions) {
                turns += winding_of(overlap, region, at);
            }
            if (first != 0 && second != 0) {
                EXPECT_EQ(turns, first > 0 && second > 0 ? 1 : 0) << at[0] << ", " << at[1];
            }
        }
    }
    for (const Region &region : overlap.regions) {
        EXPECT_EQ(side_of(a, region.inside_a, 0), 1);
        EXPECT_EQ(side_of(b, region.inside_b, 0), 1);
        EXPECT_LE(distance(points_of(on_a.get(), {region.inside_a})[0],
                           points_of(on_b.get(), {region.inside_b})[0]),
                  tolerance);
    }
}

// Of a region, in space, as of a face that its boundary bounds.
inline double area_on(const nurbs *surface, const Overlap &overlap, const Region &region) {
    std::vector<int64_t> sizes;
    std::vector<const nurbs *> curves;
    for (const std::vector<size_t> &loop : region.loops) {
        sizes.push_back(std::ssize(loop));
        for (const size_t i : loop) {
            curves.push_back(overlap.crossing.found.branches[i].on.get());
        }
    }
    nurbs_face *made = nullptr;
    require_ok(nurbs_face_create(surface, std::ssize(sizes), sizes.data(), curves.data(), nullptr, nullptr,
                                 1e-6, NURBS_AS_ORIENTED, nullptr, &made));
    const Face face(made);
    double area = 0;
    require_ok(nurbs_face_area(made, 1e-9, &area, nullptr));
    return area;
}
inline double area_on(const nurbs *surface, const Overlap &overlap) {
    double area = 0;
    for (const Region &region : overlap.regions) {
        area += area_on(surface, overlap, region);
    }
    return area;
}

} // namespace face_regions
