// SPDX-License-Identifier: MIT
// Bounds how far a triangle is from a surface that has several pieces over it.
#pragma once

#include "mesh/cells/cell_nets.h"
#include "mesh/proof/cut_triangle.h"

#include <unordered_map>
#include <vector>

namespace nrb::mesh {

// In the domain, the triangle is cut along the lines at which pieces end. The surface over each part is close
// to triangles in space whose corners are on the surface; and those are as close to the whole triangle as
// their corners are, since it is convex. Where the surface bends in one piece only, or its parametrisation
// changes its speed from piece to piece, this is far better than a bound by the largest second derivatives of
// all pieces.
class PieceBound {
public:
    PieceBound(const Spline &surface, CellNets &nets) : surface_(surface), nets_(nets) {}

    // `block`: the part of the domain that the triangle is in, inside which the surface has no kinks or
    // jumps. `enough`: a bound that does not exceed this need not be improved.
    TriangleBound bound(const std::array<TriangleCorner, 3> &corners, const PieceRange &pieces,
                        const Rectangle &block, double enough);

private:
    void add(const CutPolygon &polygon, const std::array<int64_t, 2> &piece, TriangleBound &result);
    [[nodiscard]] CellPart whole_piece(const std::array<int64_t, 2> &piece);
    [[nodiscard]] bool is_enough(const CellPart &cell, double allowed);
    void bound_parts(const CellPart &cell);
    void add_parts(const CutPolygon &polygon, double off, TriangleBound &result) const;
    [[nodiscard]] std::array<TriangleCorner, 3> part(size_t i) const noexcept {
        return {corners_[0], corners_[i], corners_[i + 1]};
    }
    void place_corners(const CutPolygon &polygon);
    [[nodiscard]] std::array<bool, 2> ends_at(int64_t place) const noexcept;
    void evaluate(int64_t first, int64_t end, const std::array<bool, 2> &from_left);
    void add_side(size_t side, const Vector3 &from, const Vector3 &to, double beside,
                  TriangleBound &result) const;
    [[nodiscard]] Rectangle around(const std::array<int64_t, 2> &piece) const noexcept;

    const Spline &surface_;
    CellNets &nets_;
    std::array<Vector3, 3> points_;
    Rectangle block_;
    double enough_ = 0, noise_ = 0;
    std::unordered_map<int64_t, HessianBox> boxes_; // of whole pieces
    std::vector<TriangleBound> bounds_;   // of the triangles that the polygon of a part is divided into
    std::vector<TriangleCorner> corners_; // of that polygon, on the surface
    std::vector<double> params_, values_;
};

} // namespace nrb::mesh
