// SPDX-License-Identifier: MIT
// How far a triangle is from the part of a surface that it stands for, both ways.
//
// Let T be a triangle of the domain with the corners v_i, and P_i = S(v_i) those of the triangle in space. For a direction d
// the function N = d . (A - w P) of the surface S = A / w, with P one of the corners, is polynomial piece by piece, and continuous
// with its first derivatives, so that its second ones bound how far it is from its linear interpolant (pairs.h).
// - d normal to the triangle: N is 0 in the corners, so this bounds the heights of S over its plane.
// - d in the plane, across a side and out of the triangle: N is <= 0 in the corners, so it bounds how far S comes out over the
//   side.
// Both together bound how far points of S are from the triangle. The other way round, the image of each side of T is near the side
// of the triangle, so that, projected on the plane, it is a curve around each point of the triangle but for those it comes
// nearer to; S over T is a surface in that curve, which passes over all of them (degree of a map of the disc).
//
// Where a triangle has others all around, the surface may come out over its sides as long as it stays over these (mesh_bound.h).
#pragma once

#include "mesh/proof/hessian_box.h"

#include <array>
#include <cmath>
#include <span>

namespace nrb::mesh {

// Part of the domain.
struct Rectangle {
    std::array<double, 2> lower{}, upper{};

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

struct TriangleBound {
    double height = 0;             // of the surface over the plane
    double out = 0;                // how far, in the plane, the surface comes out of the triangle
    double beside = 0;             // how far from the sides their images are
    std::array<double, 3> sides{}; // from each of them
    std::array<double, 3> outs{};  // how far the surface comes out over each side, in the plane
    // In the plane alone, how far images of sides are from them; the most of the second derivatives of heights along the sides; and how far
    // corners are from the plane.
    std::array<double, 3> across{infinity, infinity, infinity}, bends{};
    double flat = 0;
    double edge =
        0; // of places between sides and curves of the border from the mesh, and the other way: by triangle_proof.h
    // At corner k points of the surface come out over side k + 1, and over side k + 2, within an angle of this tangent, as
    // seen along a direction up to 30 degrees off the normal.
    std::array<std::array<double, 2>, 3> turns{
        {{infinity, infinity}, {infinity, infinity}, {infinity, infinity}}};
    // Likewise the angles within which the images of the sides themselves come inside.
    std::array<std::array<double, 2>, 3> leans = turns;
    std::array<double, 3>
        sines{};               // of the angles, and 1 of those that are obtuse as seen along such a direction
    double whole = infinity;   // no point of the surface is farther from the triangle
    double weighed = infinity; // by so much what corners are moved by may move places between them
    std::array<double, 3> angles{4, 4, 4}; // at the corners
    double altitude = 0;                   // the least one of the triangle
    Vector3 normal{};                      // 0: the triangle has none

    // By itself: the distance of every point of the part of the surface from the triangle, and the other way round.
    [[nodiscard]] double from_shape() const noexcept {
        return std::min(diagonal(height, out) * (1 + 4 * eps), whole);
    }
    [[nodiscard]] double from_mesh() const noexcept { return std::max(height, beside); }
};

// The cells cover the triangle. Corners may be rounded; what that moves comes on top of these bounds. Infinite where weights may not
// be positive.
TriangleBound triangle_bound(const std::array<TriangleCorner, 3> &corners,
                             std::span<const CellPart> cells) noexcept;
// How far points of the surface over the triangle are from those with the same parameters on it: in less time, and no less than both
// distances.
double equal_parameter_bound(const std::array<TriangleCorner, 3> &corners,
                             std::span<const CellPart> cells) noexcept;

} // namespace nrb::mesh
