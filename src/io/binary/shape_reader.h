// SPDX-License-Identifier: MIT
// The shapes of a body, from the parts that shape_table.h describes.
#pragma once

#include "io/binary/shape_table.h"

namespace nrb::io {

class ShapeReader {
public:
    // Passes over the parts. Throws Status::truncated.
    ShapeReader(ByteReader &reader, const ShapeSizes &sizes);

    // Makes them. Throws Status::syntax for numbers that no shape has, length, direction; axes, dimension for splines of another
    // kind.
    void make(const std::vector<SplinePtr> &splines);
    // Null for -1. Precondition: an index below the number of them.
    [[nodiscard]] model::CurveShapePtr curve(int64_t index) const;
    [[nodiscard]] model::SurfaceShapePtr surface(int64_t index) const;

private:
    [[nodiscard]] model::CurveShapePtr next_curve(const std::vector<SplinePtr> &splines);
    [[nodiscard]] std::vector<model::CurvePiece> next_pieces(int64_t count, int dim, int &depth);
    [[nodiscard]] model::SurfaceShapePtr next_surface(const std::vector<SplinePtr> &splines);

    ByteReader piece_reader_, curve_reader_, surface_reader_;
    ShapeSizes sizes_;
    int64_t pieces_left_;
    std::vector<model::CurveShapePtr> curves_;
    std::vector<model::SurfaceShapePtr> surfaces_;
    std::vector<int> curve_depths_, surface_depths_; // how many shapes lie in one another
};

} // namespace nrb::io
