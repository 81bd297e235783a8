// SPDX-License-Identifier: MIT
// Reads the shapes of a body, from the parts that shape_table.h describes.
#pragma once

#include "io/binary/shape_table.h"

namespace nrb::io {

class ShapeReader {
public:
    // Takes the three parts from `reader`, which moves on past them. Throws Status::truncated.
    ShapeReader(ByteReader &reader, const ShapeSizes &sizes);

    // Makes all shapes. Throws Status::syntax, length, direction, empty_domain or angle for numbers that no
    // shape has; axes or dimension for splines and curves of a wrong kind.
    void make(const std::vector<SplinePtr> &splines);
    // The shape with an index; null for -1. Precondition: the index is below the number of such shapes.
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
    std::vector<int> curve_depths_, surface_depths_; // for each shape: how deeply others are nested in it
};

} // namespace nrb::io
