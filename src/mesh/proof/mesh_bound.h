// SPDX-License-Identifier: MIT
// How far all triangles together are from a surface, both ways.
//
// A triangle T with normal n may have others all around it, those that share a corner with it: its star. Let none of them be turned
// against n by more than a < 60 degrees, so that the star, projected along n, lies over the plane as the graph of a function that rises by at
// most tan a; and let m be the least altitude of a triangle of the star.
// - The function that is 1 in the corners of T, 0 in all others and linear on each triangle has a gradient of at most 1 / m, so that
//   every way out of the star from T is at least m cos a long, as seen along n.
// - A point x of the surface over T, with a height h, that comes out of T by r < m cos a is over the star, whose height there is at
//   most r tan a: the distance is at most h + r tan a.
// - The image of the border of the star is less than m cos a away from that border, so that it winds around each point p of T as that does:
//   some point x of the surface over the star is over p. Let x belong to T' of the star, with height h' over its plane, r' out of T'. Along n, the height over the plane of T' is h' / cos a;
//   T' comes as near as r' + h' sin a to p, and on the way from there to p the plane of T' and the star part by no more than that times the most that
//   gradients of the star differ, b. These are images of the normals under the central projection, which stretches by 1 / cos^2 a at most.
#pragma once

#include "mesh/proof/triangle_bound.h"

#include <cstdint>
#include <vector>

namespace nrb::mesh {

// Distances of one triangle.
struct Distances {
    double from_shape = 0, from_mesh = 0;

    [[nodiscard]] double most() const noexcept { return std::max(from_shape, from_mesh); }
};

class MeshBound {
public:
    explicit MeshBound(size_t points) : points_(points) {}

    // Points that do not have triangles all around.
    void set_border(int32_t point) noexcept { points_[static_cast<size_t>(point)].border = true; }
    // Of every triangle first its normal, then its bound, then the distances of each.
    void add_normal(const std::array<int32_t, 3> &corners, const Vector3 &normal) noexcept;
    void add(const std::array<int32_t, 3> &corners, const TriangleBound &bound) noexcept;
    [[nodiscard]] Distances distances(const std::array<int32_t, 3> &corners,
                                      const TriangleBound &bound) const noexcept;

private:
    // The most of the triangles around.
    struct Point {
        bool border = false;
        Vector3 normal{};  // the sum, and then the mean
        double turned = 0; // from the mean, as a chord of the unit sphere
        double altitude = infinity;
        double height = 0, out = 0, beside = 0;
    };
    std::vector<Point> points_;
};

} // namespace nrb::mesh
