// SPDX-License-Identifier: MIT
// The binary form of a model.
#pragma once

#include "io/binary/face_table.h"
#include "io/binary/shape_table.h"
#include "io/binary/texts.h"
#include "model/model.h"

namespace nrb::io {

// The body, each part at a multiple of 64 bytes:
//
//     64   numbers of named splines, notes, parts, uses, faces, loops, curves of loops, edges, vertices,
//          pieces of curves, curve shapes, surface shapes, bytes of text, distinct splines, layers,
//          memberships in layers; metres per unit, a double
//     256  for each named spline: its spline
//          for each note: its entity type, line and reason
//          for each use: its parent or -1, its part, the twelve numbers of its placement
//          for each face: its shape or -1; its part; flags: 1 the outer normal is opposite to that of the
//              surface, 2 it has a colour, 4 it bounds a void; red, green, blue; its solid or -1
//          for each face, then for each named spline: the number of its layers; then these layers
//          the faces: see face_table.h
//          for each curve of their loops: its edge in the model or -1
//          for each edge: its curve, its shape or -1, its two vertices or -1, its part
//          for each vertex: its three coordinates
//          the shapes: see shape_table.h
//          the texts: names of splines, texts of notes, names of parts, uses, faces and layers
//          the splines: see spline_table.h
class ModelBytes {
public:
    // The model must outlive this object.
    explicit ModelBytes(const model::Model &model);

    [[nodiscard]] size_t size() const noexcept { return size_; }
    // Precondition: `out` has size() bytes.
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
    std::vector<int64_t> coedge_edges_; // for each curve of all loops
    std::vector<EdgeEntry> edges_;
    size_t size_;
};

// Throws what ByteReader, spline_from(), FaceReader and ShapeReader throw, and Status::syntax, factor, axes
// or dimension for numbers that no model has.
model::Model model_from(std::span<const unsigned char> bytes);

} // namespace nrb::io
