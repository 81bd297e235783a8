// SPDX-License-Identifier: MIT
// Bounds the distance between a triangle and the part of a surface that it stands for, in both directions.
//
// Let T be a triangle of the domain with corners v_i, and P_i = S(v_i) the corners of the triangle in space.
// For a direction d, and one of the corners P, consider the function N = d . (A - w P) of the surface
// S = A / w: N / w is the component of S - P along d. N is piecewise polynomial with continuous first
// derivatives, so its second derivatives bound its distance from its linear interpolant (pairs.h).
// - d normal to the triangle: N is 0 at the corners, so this bounds the height of S above the plane.
// - d in the plane, normal to a side and pointing out of the triangle: N is <= 0 at the corners, so this
//   bounds how far S comes out over the side.
// Both together bound the distance of points of S from the triangle.
//
// The other direction: the image of each side of T is near the side of the triangle. Projected onto the
// plane, the images form a closed curve. It winds once around each point of the triangle, unless it passes
// that point within the distance of the images from the sides. S over T is a disc that spans this curve, so
// it passes over all points around which the curve winds (degree of a map of the disc).
//
// Where a triangle has neighbours all around, the surface may come out over its sides as long as it stays
// over the neighbours (mesh_bound.h).
#pragma once

#include "mesh/proof/hessian_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace nrb::mesh {

// A rectangle of the domain.
struct Rectangle {
    std::array<double, 2> lower{}, upper{};

    bool operator==(const Rectangle &) const = default;
    [[nodiscard]] double side(size_t k) const noexcept { return upper[k] - lower[k]; }
    [[nodiscard]] std::array<double, 2> sides() const noexcept { return {side(0), side(1)}; }
    [[nodiscard]] std::array<double, 2> middle() const noexcept {
        return {lower[0] / 2 + upper[0] / 2, lower[1] / 2 + upper[1] / 2};
    }
};

// A corner: parameters, and the point in space.
struct TriangleCorner {
    std::array<double, 2> param;
    Vector3 point;
};

// A cell that the triangle may reach into.
struct CellPart {
    const HessianBox *box;
    Rectangle part;
};

// Upper bounds for a triangle and its part of the surface. The image of a side is the curve on the surface
// that belongs to the side of the triangle of the domain. Side k is opposite corner k.
struct TriangleBound {
    double height = 0;             // of the surface above the plane
    double out = 0;                // how far, in the plane, the surface comes out of the triangle
    double beside = 0;             // distance of the images of the sides from these
    std::array<double, 3> sides{}; // the same for each side
    std::array<double, 3> outs{};  // how far, in the plane, the surface comes out over each side
    // The height of the surface where it comes out over each side, as seen along a direction up to 30 degrees
    // off the normal.
    std::array<double, 3> nears{infinity, infinity, infinity};
    // across: distance of the images of the sides from these in the plane alone. bends: the second
    // derivatives of the height along the sides. flat: what the corners add to the height, since they are in
    // the plane only to rounding.
    std::array<double, 3> across{infinity, infinity, infinity}, bends{};
    double flat = 0;
    // Distance, both ways, between the mesh and what lies between border sides and their curves. Set by
    // TriangleProof (triangle_proof.h).
    double edge = 0;
    // turns[k]: at corner k, points of the surface come out over side k + 1, and over side k + 2, within
    // angles of these tangents, as seen along a direction up to 30 degrees off the normal. The foreshortening
    // of the sides in that view is left to is_beside() of mesh_bound.cpp.
    std::array<std::array<double, 2>, 3> turns{
        {{infinity, infinity}, {infinity, infinity}, {infinity, infinity}}};
    // leans[k]: likewise, the angles within which the images of these sides come inside.
    std::array<std::array<double, 2>, 3> leans = turns;
    // Lower bounds on the sines of the angles; 1 for angles that are obtuse as seen along any such direction.
    std::array<double, 3> sines{};
    double whole = infinity;               // distance of any point of the surface from the triangle
    double weighed = infinity;             // places between corners move at most this times as far
    std::array<double, 3> angles{4, 4, 4}; // at the corners, from above
    std::array<double, 3> altitudes{};     // of the corners, from below
    Vector3 normal{};                      // 0: the triangle has none

    // For the triangle by itself: the distance of its part of the surface from it, and its distance from the
    // surface.
    [[nodiscard]] double from_shape() const noexcept {
        return std::min(diagonal(height, out) * (1 + 4 * eps), whole);
    }
    [[nodiscard]] double from_mesh() const noexcept { return std::max(height, beside); }
    // The height of the surface where it comes out over a side, and where it comes out over any.
    [[nodiscard]] double height_over(size_t side) const noexcept { return std::min(height, nears[side]); }
    [[nodiscard]] double height_beyond() const noexcept {
        return std::max({height_over(0), height_over(1), height_over(2)});
    }
    [[nodiscard]] double least_altitude() const noexcept {
        return std::min({altitudes[0], altitudes[1], altitudes[2]});
    }
    [[nodiscard]] bool has_plane() const noexcept { return normal.x != 0 || normal.y != 0 || normal.z != 0; }
};

// The angle between two normals, as a chord of the unit sphere, from above: 2 where a triangle has none.
inline double chord_between(const TriangleBound &a, const TriangleBound &b) noexcept {
    return a.has_plane() && b.has_plane() ? length(a.normal - b.normal) + 8 * eps : 2;
}

// Of one triangle T. from_shape: how far the part of the surface that T stands for is from the mesh; from_mesh:
// how far T is from the surface.
struct Distances {
    double from_shape = 0, from_mesh = 0;

    [[nodiscard]] double most() const noexcept { return std::max(from_shape, from_mesh); }
};

// Precondition: the cells cover the triangle. The corners may be rounded; what that moves comes on top of
// these bounds. Infinite where weights may not be positive. alone: what neighbours ask for is not wanted (turns, leans).
TriangleBound triangle_bound(const std::array<TriangleCorner, 3> &corners, std::span<const CellPart> cells,
                             bool alone = false) noexcept;
// A bound on the distance between points of the surface and of the triangle at equal parameters. It is a
// bound on both distances, too, and takes less time than triangle_bound().
double equal_parameter_bound(const std::array<TriangleCorner, 3> &corners,
                             std::span<const CellPart> cells) noexcept;

} // namespace nrb::mesh
