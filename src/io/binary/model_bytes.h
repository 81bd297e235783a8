// SPDX-License-Identifier: MIT
// A model as bytes.
#pragma once

#include "io/binary/face_table.h"
#include "io/binary/shape_table.h"
#include "io/binary/texts.h"
#include "model/model.h"

namespace nrb::io {

// The body, each part at a multiple of 64 bytes:
//
//     64   numbers of named splines, notes, parts, uses, faces, loops, their curves, edges, vertices, pieces of curves, shapes of
//          curves, shapes of surfaces, bytes of text, splines that differ, layers, places in layers; metres per unit, a double
//     256  which spline each named one is
//          of each note its entity type, line and reason
//          of each use: its parent or -1, its part, and twelve numbers of its placement
//          of each face: its shape or -1, its part, flags: 1 the normal outwards is against that of the surface, 2 it has a colour,
//              4 it bounds a void; red, green, blue; the number of its solid or -1
//          of each face, then of each named spline, in how many layers it is; then in which ones
//          the faces: see face_table.h
//          of each of their curves the edge of the model, -1 if it has none
//          of each edge: its curve, its shape or -1, two vertices or -1, its part
//          the vertices, three numbers each
//          the shapes: see shape_table.h
//          the texts: names of splines, words of notes, names of parts, uses, faces and layers
//          the splines: see spline_table.h
class ModelBytes {
public:
    // The model has to outlive this.
    explicit ModelBytes(const model::Model &model);

    [[nodiscard]] size_t size() const noexcept { return size_; }
    // Precondition: `out` has that size.
    void write(std::span<unsigned char> out) const noexcept;

private:
    struct EdgeEntry {
        int64_t curve, shape;
    };
    void add_texts();
    void add_edges();
    [[nodiscard]] size_t sum_of_sizes() const noexcept;
    void write_sizes(ByteWriter &writer) const noexcept;
    void write_uses(ByteWriter &writer) const noexcept;
    void write_faces(ByteWriter &writer) const noexcept;
    void write_edges(ByteWriter &writer) const noexcept;
    void write_layers(ByteWriter &writer) const noexcept;
    [[nodiscard]] size_t count_in_layers() const noexcept;

    const model::Model &model_;
    SplineTable splines_;
    FaceTable faces_;
    ShapeTable shapes_;
    Texts texts_;
    std::vector<int64_t> named_;
    std::vector<int64_t> face_shapes_;
    std::vector<int64_t> coedge_edges_; // of all curves of all faces
    std::vector<EdgeEntry> edges_;
    size_t size_;
};

// Throws what ByteReader, spline_from(), FaceReader and ShapeReader do, and Status::syntax, factor for numbers that no model has.
model::Model model_from(std::span<const unsigned char> bytes);

} // namespace nrb::io
