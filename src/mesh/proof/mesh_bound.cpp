// SPDX-License-Identifier: MIT
#include "mesh/proof/mesh_bound.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// The chord of 60 degrees is 1.
constexpr double most_turned = 0.95;

bool is_zero(const Vector3 &v) noexcept {
    return v.x == 0 && v.y == 0 && v.z == 0;
}

} // namespace

void MeshBound::add_normal(const std::array<int32_t, 3> &corners, const Vector3 &normal) noexcept {
    for (const int32_t corner : corners) {
        Point &point = points_[static_cast<size_t>(corner)];
        point.normal = point.normal + normal;
    }
}

void MeshBound::add(const std::array<int32_t, 3> &corners, const TriangleBound &bound) noexcept {
    for (const int32_t corner : corners) {
        Point &point = points_[static_cast<size_t>(corner)];
        if (point.altitude == infinity && !is_zero(point.normal)) {
            point.normal = unit(point.normal);
        }
        const double turned = is_zero(bound.normal) ? 2 : length(bound.normal - point.normal) + 8 * eps;
        point.turned = std::max(point.turned, turned);
        point.altitude = std::min(point.altitude, bound.altitude);
        point.height = std::max(point.height, bound.height);
        point.out = std::max(point.out, bound.out);
        point.beside = std::max(point.beside, bound.beside);
    }
}

// Chords of angles add up to at least the chord of their sum, and tan a <= 1.02 c / (1 - c^2 / 2) for a chord c.
Distances MeshBound::distances(const std::array<int32_t, 3> &corners,
                               const TriangleBound &bound) const noexcept {
    const Distances alone{bound.from_shape(), bound.from_mesh()};
    double turned = 0, apart = 0, altitude = infinity, height = 0, out = 0, beside = 0;
    for (const int32_t corner : corners) {
        const Point &point = points_[static_cast<size_t>(corner)];
        if (point.border) {
            return alone;
        }
        const double from_mean = length(bound.normal - point.normal) + 8 * eps;
        turned = std::max(turned, point.turned + from_mean);
        apart = std::max(apart, point.turned + std::max(point.turned, from_mean));
        altitude = std::min(altitude, point.altitude);
        height = std::max(height, point.height);
        out = std::max(out, point.out);
        beside = std::max(beside, point.beside);
    }
    const double cosine = 1 - turned * turned / 2;
    const double apart_of_all = std::min(2 * turned, 2 * apart);
    if (!(turned < most_turned && std::max(out + height, beside) < 0.99 * altitude * cosine)) {
        return alone;
    }
    const double slope = turned / cosine, more = 1 + 64 * eps,
                 parting = 1.05 * apart_of_all / (cosine * cosine);
    const Distances around{(bound.height + bound.out * slope) * more,
                           (height / cosine + (out + height * slope) * parting) * more};
    return {std::min(alone.from_shape, around.from_shape), std::min(alone.from_mesh, around.from_mesh)};
}

} // namespace nrb::mesh
