// SPDX-License-Identifier: MIT
// How far all triangles together are from a surface, both ways.
//
// A triangle T with normal n may have others all around it, those that share a corner with it: its star. Everything is seen along n.
//
// By the star. Let no triangle of it be turned against n by more than a < 60 degrees, so that the star lies over the plane, and let m
// be the least altitude of its triangles.
// It must not cover the plane more than once: around a corner angles add up to less than 3 pi, and none of its sides is the border of the
// mesh.
// - The function that is 1 in the corners of T, 0 in all others and linear on each triangle has a gradient of at most 1 / m, so that
//   every way out of the star from T is at least m cos a long.
// - Thus a point x of the surface over T, of the height h, which comes out by r, is over the star, the planes of which are at most r tan a
//   away from that of T there: the distance is at most h + r tan a.
// - The image of the border of the star is less than m cos a away from that border, so that it winds around each point p of T as that does:
//   some point x of the surface over the star is over p.
//
// By the sides. Let T'' be the triangles across the sides of T, turned against n by no more than 29 degrees. For each of them, let the
// following angles at both ends P of the side be less than that of T'' there: the one within which the surface over T comes out (turns
// of triangle_bound.h), and the one within which the image of the other side of T'' at P comes inside (leans); it comes out within 45 degrees.
// - A point x of the surface over T that comes out over a side is within the angles of T'' at both ends of it, and so over T'': with
//   the height h of x and the angle b of the planes, the distance is at most h + r tan b.
// - Seen from P, the images of the other sides of T'' are not over T, so that the image of the border of all four triangles winds around
//   each point p of T as that border does, once: some point x of the surface over them is over p. It belongs to T, or to a T'', and then, in
//   the plane across the common side, it is h' over T'' and r' over the side: turned by b its height over T is at most h' cos b + r' sin b, or
//   h' / cos b.
// - Where a side of T is the border of the mesh, x may come out over it, and its image may come inside by as much as it is beside the
//   side: where it passes a point p on the straight way from the side, it is no farther from p.
// - Where x is outside of the face, between a side of T at the border and its curve, that is near p (edge of triangle_bound.h). Where it is over T'',
//   the curve is as near to the foot of x on the plane of that, from which p is r' sin b away across the plane, and its distance from x times
//   sin b along it; and r' is at most the distance of x from the side of T'' at the border.
#pragma once

#include "mesh/proof/point_fans.h"
#include "mesh/proof/triangle_bound.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

// Distances of one triangle.
struct Distances {
    double from_shape = 0, from_mesh = 0;

    [[nodiscard]] double most() const noexcept { return std::max(from_shape, from_mesh); }
};

class MeshBound {
public:
    // Each triangle has its bound; wanted: those of which the distances are going to be asked for.
    MeshBound(size_t points, std::span<const MeshTriangle> triangles, std::span<const TriangleBound> bounds,
              std::span<const int32_t> wanted);

    // Of a wanted one, for all of the surface over the triangles, wherever the face ends. What is not more than `enough` is not looked at more
    // closely.
    [[nodiscard]] Distances distances(size_t triangle, double enough) const;
    // How far places of a wanted triangle may be from the face where it ends before what they are near, of which they are so far.
    [[nodiscard]] double edge_about(size_t triangle, double from_mesh) const noexcept;

private:
    // The most of the triangles around.
    struct Point {
        Vector3 normal{}; // the sum, and then the mean
        double angle = 0; // the sum of those around it
        bool on_border = false;
        double turned = 0; // from the mean, as a chord of the unit sphere
        double altitude = infinity, height = 0, out = 0, beside = 0;
        double border = 0; // how far the border is from its sides
    };
    void set_point(int32_t number);
    void add_corner(size_t triangle, size_t corner, Point &point) const noexcept;
    struct Around {
        double turned = 0, altitude = infinity, height = 0, out = 0, beside = 0, border = 0;
    };
    [[nodiscard]] Around around(size_t triangle) const noexcept;
    [[nodiscard]] Distances by_star(size_t triangle, const Around &around) const noexcept;
    [[nodiscard]] Distances by_sides(size_t triangle) const noexcept;
    [[nodiscard]] const Point &point_of(size_t triangle, size_t corner) const noexcept {
        return points_[static_cast<size_t>(triangles_[triangle].points[corner % 3])];
    }
    struct Neighbour {
        int32_t triangle = -1;
        size_t side = 0;
    };
    [[nodiscard]] Neighbour across(size_t triangle, size_t side) const noexcept;
    [[nodiscard]] bool is_beside(size_t triangle, size_t side, const Neighbour &next) const noexcept;
    [[nodiscard]] Distances over_side(size_t triangle, size_t side) const noexcept;
    [[nodiscard]] Distances over_border(size_t triangle, size_t side) const noexcept;

    std::span<const MeshTriangle> triangles_;
    std::span<const TriangleBound> bounds_;
    std::vector<Point> points_;
    PointFans fans_;
};

} // namespace nrb::mesh
