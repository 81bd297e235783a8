// SPDX-License-Identifier: MIT
// Bounds the distance between a surface and a mesh, triangle by triangle and in both directions, with the
// help of neighbouring triangles.
//
// A triangle T with normal n may have neighbours all around it: the triangles that share a corner with it
// form its star. S(T) is the part of the surface that T stands for. Everything is seen along n: a point is
// over a triangle if its projection along n is in that of the triangle.
//
// By the star. Let the normals of its triangles be within an angle a < 60 degrees of n, so that the star lies
// over the plane, and let m be the least altitude of its triangles. The star must not cover the plane more
// than once. Around each corner of T let no side be on the border of the mesh; then the angles, as seen from
// any direction near n, add up to a multiple of 2 pi, which must not be 4 pi. An angle in a plane that is
// turned by b looks at most 1 / cos b times as large as it is: so let the angles in space add up to less than
// 4 pi cos b, as seen along the mean of the normals there, which none is farther than b from.
// - Consider the function that is 1 at the corners of T, 0 at all other corners, and linear on each triangle.
//   Its gradient is at most 1 / m, so every path from T out of the star has a length of at least m cos a.
// - So a point x of S(T), at height h above the plane of T and out of T by r, is over the star if
//   r < m cos a. There the star is at most r tan a away from the plane of T, so the distance of x is at most
//   h + r tan a.
// - If the image of the border of the star is less than m cos a away from that border, it winds around each
//   point p of T as the border does. Hence some point of the surface that belongs to the star is over p.
//
// By the sides. Let U be a triangle across a side of T, with its normal within 29 degrees of n. At both ends
// P of the side, let two angles be less than the angle of U: the one within which S(T) comes out over the
// side (`turns` of triangle_bound.h), and the one within which the image of the other side of U at P comes
// inside (`leans`). Let that image come out of U within 45 degrees only.
// - A point x of S(T) that comes out over a side is within the angles of U at both ends of it, and so over U.
//   Let h be its height above the plane of T (`nears` of triangle_bound.h bounds it), r its distance from the
//   side in that plane, and b the angle between the planes: then the distance of x is at most h + r tan b.
// - As seen from P, the images of the other sides of U are not over T. So the image of the border of T and
//   all its U together winds around each point p of T as that border does: once. Hence some point x of their
//   surface is over p. If it belongs to an S(U), consider a plane perpendicular to the common side. There x
//   is at the height h' above U, and may be beyond the side by r'. Turned by b, its height above T is at most
//   h' cos b + r' sin b, or h' / cos b if its foot is not beyond the side. As seen along n, x comes out over the
//   side, so that h' is bounded by the `nears` of U.
// - Where a side of T is on the border of the mesh, S(T) may come out over it, and the image of the side may
//   come inside. Let the side move to its image along straight lines: where it passes a point p of T, the
//   image is no farther from p than it is from the side.
// - The point x over p may be outside of the face, between a border side and its curve. If that is a side of
//   T, the curve is near p (`edge` of triangle_bound.h). If x belongs to an S(U), the curve is as near to the
//   foot of x on the plane of U. From that foot p is at most r' sin b away across the plane and |px| sin b
//   along it, and r' is at most the distance of x from the border side of U.
#pragma once

#include "mesh/proof/neighbours.h"
#include "mesh/proof/triangle_bound.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

class MeshBound {
public:
    // bounds: those of all triangles. wanted: the triangles whose distances will be asked for.
    MeshBound(size_t points, std::span<const MeshTriangle> triangles, std::span<const TriangleBound> bounds,
              std::span<const int32_t> wanted);

    // The distances of a wanted triangle. They are for all of the surface over the triangles, regardless of
    // where the face ends. Bounds of at most `enough` are not improved any further, and those of at most `allowed`
    // not by what takes long.
    [[nodiscard]] Distances distances(size_t triangle, double enough, double allowed) const;
    // Bounds the distance of points of a wanted triangle from the face where the points of the surface near
    // them lie beyond its border. from_mesh: their distance from those points.
    [[nodiscard]] double edge_about(size_t triangle, double from_mesh) const noexcept;

private:
    // The worst values of the triangles around a point.
    struct Point {
        Vector3 normal{}; // the sum of all normals, and then its direction
        double angle = 0; // the sum of the angles around it
        bool on_border = false;
        double turned = 0; // of a normal from the mean, as a chord of the unit sphere
        double altitude = infinity, height = 0, out = 0, beside = 0;
    };
    void set_point(int32_t number);
    void add_corner(size_t triangle, size_t corner, Point &point) const noexcept;
    struct Around {
        double turned = 0, altitude = infinity, height = 0, out = 0, beside = 0;
        bool on_border = false;
    };
    [[nodiscard]] Around around(size_t triangle) const noexcept;
    [[nodiscard]] Distances by_star(size_t triangle, const Around &around) const noexcept;
    [[nodiscard]] Distances by_sides(size_t triangle) const noexcept;
    [[nodiscard]] const Point &point_of(size_t triangle, size_t corner) const noexcept {
        return points_[static_cast<size_t>(neighbours_[triangle].points[corner % 3])];
    }
    [[nodiscard]] bool is_beside(size_t triangle, size_t side, const Neighbour &next) const noexcept;
    [[nodiscard]] Distances over_side(size_t triangle, size_t side) const noexcept;
    [[nodiscard]] Distances over_border(size_t triangle, size_t side) const noexcept;

    std::span<const TriangleBound> bounds_;
    std::vector<Point> points_;
    Neighbours neighbours_;
};

} // namespace nrb::mesh
