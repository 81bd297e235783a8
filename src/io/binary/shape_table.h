// SPDX-License-Identifier: MIT
// The shapes in a body, each stored once: the analytic forms of curves and surfaces. Three parts:
//
//     for each piece of a curve: the curve, its range, 1 if it runs in the direction of the curve, else 0
//     for each curve: kind, dimension, spline or -1, number of pieces, place, two sizes
//     for each surface: kind; curve or -1; basis or -1; spline or -1; flags: 1 forward in u, 2 in v; place;
//         two sizes; range of u; range of v; vector; distance
//
// All numbers have 64 bits. A place consists of an origin, the axes x, y, z, what rounding left out of each
// axis, and the directions that were given for z and x. A curve or surface comes after those of which it
// consists. Fields that a kind does not use are 0.
#pragma once

#include "io/binary/spline_table.h"
#include "model/shapes/surface_shape.h"

namespace nrb::io {

struct ShapeSizes {
    int64_t pieces = 0, curves = 0, surfaces = 0;
};

class ShapeTable {
public:
    // The index of a shape; -1 for null.
    int64_t add(const model::CurveShapePtr &shape, SplineTable &splines);
    int64_t add(const model::SurfaceShapePtr &shape, SplineTable &splines);

    [[nodiscard]] ShapeSizes sizes() const noexcept {
        return {std::ssize(pieces_), std::ssize(curves_), std::ssize(surfaces_)};
    }
    // The size from the start of the first part to the end of the last one, padding included.
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
