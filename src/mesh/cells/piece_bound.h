// SPDX-License-Identifier: MIT
// How far a triangle is from a surface of several pieces.
#pragma once

#include "mesh/cells/cell_nets.h"
#include "mesh/proof/cut_triangle.h"

#include <unordered_map>
#include <vector>

namespace nrb::mesh {

// The triangle is cut along the lines at which pieces end. Each part is near the triangle of its own corners, which are places of the
// surface; and that is as near to the whole triangle as its corners are, since that is convex. Where the surface bends
// in one piece only, or its parameters change their pace, that is far better than the most of all second derivatives.
class PieceBound {
public:
    PieceBound(const Spline &surface, CellNets &nets) : surface_(surface), nets_(nets) {}

    // `block`: a part of the domain in which the surface has no kinks, and from which it is looked at. `enough`: what is within it
    // needs no better proof.
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
    void add_side(size_t side, const Vector3 &from, const Vector3 &to, double beside,
                  TriangleBound &result) const;
    [[nodiscard]] Rectangle around(const std::array<int64_t, 2> &piece) const noexcept;

    const Spline &surface_;
    CellNets &nets_;
    std::array<Vector3, 3> points_;
    Rectangle block_;
    double enough_ = 0, noise_ = 0;
    std::unordered_map<int64_t, HessianBox> boxes_; // of whole pieces
    std::vector<TriangleBound> bounds_;             // of the parts of a polygon
    std::vector<TriangleCorner> corners_;           // of a polygon
    std::vector<double> params_, values_;
};

} // namespace nrb::mesh
