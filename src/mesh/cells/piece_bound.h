// SPDX-License-Identifier: MIT
// How far a triangle is from a surface of several pieces.
#pragma once

#include "mesh/cells/cell_nets.h"
#include "mesh/proof/cut_triangle.h"

namespace nrb::mesh {

// The triangle is cut along the lines at which pieces end. Each part is near the triangle of its own corners, which are places of the
// surface; and that is as near to the whole triangle as its corners are, since that is convex. Where the surface bends
// in one piece only, or its parameters change their pace, that is far better than the most of all second derivatives.
class PieceBound {
public:
    PieceBound(const Spline &surface, CellNets &nets) : surface_(surface), nets_(nets) {}

    // `block`: a part of the domain in which the surface has no kinks, and from which it is looked at.
    TriangleBound bound(const std::array<TriangleCorner, 3> &corners, const PieceRange &pieces,
                        const Rectangle &block);

private:
    void add(const CutPolygon &polygon, const std::array<int64_t, 2> &piece, TriangleBound &result);
    void place_corners(const CutPolygon &polygon);
    void add_side(size_t side, const Vector3 &from, const Vector3 &to, double beside,
                  TriangleBound &result) const;
    [[nodiscard]] Rectangle around(const std::array<int64_t, 2> &piece) const noexcept;

    const Spline &surface_;
    CellNets &nets_;
    std::array<TriangleCorner, 3> whole_;
    std::array<Vector3, 3> points_;
    Rectangle block_;
    double noise_ = 0;
    std::vector<TriangleCorner> corners_; // of a polygon
    std::vector<double> params_, values_;
};

} // namespace nrb::mesh
