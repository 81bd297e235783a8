// SPDX-License-Identifier: MIT
// How far all triangles together are from a surface, both ways.
//
// A triangle T with normal n may have others all around it, those that share a corner with it: its star. Everything is seen along n.
// Let no triangle of the star be turned against n by more than a < 60 degrees, so that the star lies over the plane, and let m
// be the least altitude of its triangles.
// It must not cover the plane more than once: around a corner angles add up to less than 3 pi, and at the border of the mesh to no more
// than 2 pi.
// - The function that is 1 in the corners of T, 0 in all others and linear on each triangle has a gradient of at most 1 / m, so that
//   every way out of the star from T is at least m cos a long.
// - At a corner the surface over a triangle T' comes out over a side of it within an angle (turns of triangle_bound.h). If that is less than the
//   angle of the triangle T'' across the side, no point of the surface over T' is over others at this corner but T' and T''. So the
//   surface over T comes out over triangles that have a side in common with it, and only surfaces over these come out over T.
// - Thus a point x of the surface over T, of the height h, which comes out by r over the side of T', is over T', whose plane
//   is at most r tan b away from that of T there, with the angle b of both: the distance is at most h + r tan b.
// - The image of the border of the star is less than m cos a away from that border, so that it winds around each point p of T as that does:
//   some point x of the surface over the star is over p. It belongs to T, or to a T' with a common side, and then, in the plane across
//   this side, it is h' over T' and r' over the side: turned by b its height over T is at most h' cos b + r' sin b, or h' / cos b.
// - Where a side of T is the border of the mesh, x may come out over it, and the image of the border may come inside by as much as it is
//   beside the side.
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

    // Of a wanted one. What is not more than `enough` is not looked at more closely.
    [[nodiscard]] Distances distances(size_t triangle, double enough);

private:
    // The most of the triangles around.
    struct Point {
        Vector3 normal{}; // the sum, and then the mean
        double angle = 0; // the sum of those around it
        bool on_border = false;
        double turned = 0; // from the mean, as a chord of the unit sphere
        double altitude = infinity, height = 0, out = 0, beside = 0;
        double turns = -1; // in terms of the sines of angles across sides; -1: not known yet
        double border = 0; // how far the border is from its sides
    };
    void set_point(int32_t number);
    void add_corner(size_t triangle, size_t corner, Point &point) const noexcept;
    [[nodiscard]] double turns_at(int32_t number);
    [[nodiscard]] double find_turns(int32_t number);
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
    [[nodiscard]] Distances over_side(size_t triangle, size_t side) const noexcept;

    std::span<const MeshTriangle> triangles_;
    std::span<const TriangleBound> bounds_;
    std::vector<Point> points_;
    PointFans fans_;
    struct Corner {
        int32_t triangle, next, previous;
        size_t corner;
    };
    std::vector<Corner> around_; // of one point
};

} // namespace nrb::mesh
