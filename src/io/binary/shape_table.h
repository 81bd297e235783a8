// SPDX-License-Identifier: MIT
// The shapes in a body, each once: what curves and surfaces are beside their splines. Three parts:
//
//     of each piece of a curve: the curve, its range, 1 if it runs in the direction of that, else 0
//     of each curve: kind, dimension, spline or -1, number of pieces, place, two sizes
//     of each surface: kind, curve or -1, basis or -1, spline or -1, flags: 1 forward in u, 2 in v; place, two sizes, range of u,
//         range of v, vector, distance
//
// All numbers have 64 bits. A place is an origin, the axes x, y, z, and what rounding left out of these. Curves and surfaces that
// others consist of stand before them. What a kind has no use for is 0.
#pragma once

#include "io/binary/spline_table.h"
#include "model/shapes/surface_shape.h"

namespace nrb::io {

struct ShapeSizes {
    int64_t pieces = 0, curves = 0, surfaces = 0;
};

class ShapeTable {
public:
    // The index of a shape, -1 of none.
    int64_t add(const model::CurveShapePtr &shape, SplineTable &splines);
    int64_t add(const model::SurfaceShapePtr &shape, SplineTable &splines);

    [[nodiscard]] ShapeSizes sizes() const noexcept {
        return {std::ssize(pieces_), std::ssize(curves_), std::ssize(surfaces_)};
    }
    // From the beginning of a part to its end.
    [[nodiscard]] size_t size_in_bytes() const noexcept;
    void write(ByteWriter &writer) const noexcept;

private:
    void write_curves(ByteWriter &writer) const noexcept;
    void write_surfaces(ByteWriter &writer) const noexcept;

    struct PieceEntry {
        int64_t curve;
        Interval range;
        bool forward;
    };
    struct CurveEntry {
        model::CurveShapePtr shape;
        int64_t spline;
    };
    struct SurfaceEntry {
        model::SurfaceShapePtr shape;
        int64_t curve, basis, spline;
    };
    std::vector<PieceEntry> pieces_;
    std::vector<CurveEntry> curves_;
    std::vector<SurfaceEntry> surfaces_;
    std::unordered_map<const void *, int64_t> known_;
};

} // namespace nrb::io
