// SPDX-License-Identifier: MIT
// The faces in a body, in three parts. Their splines are in the spline table of the body.
//
//     for each face: its surface; the number of its loops; flags: 1 gaps are larger than the tolerance;
//         its tolerance
//     for each loop: the number of its curves; flags: 1 the face was made with the loop reversed
//     for each curve: the curve; its edge or -1; the key of the edge; flags: 1 the edge runs against the
//         curve, 2 their distance is proven; that distance, or else 0
//
// All numbers have 64 bits; splines are indices in the table.
#pragma once

#include "face/face.h"
#include "io/binary/spline_table.h"

namespace nrb::io {

struct FaceSizes {
    int64_t faces = 0, loops = 0, coedges = 0;
};

class FaceTable {
public:
    // The face must outlive this object.
    void add(const face::Face &face, SplineTable &splines);

    [[nodiscard]] FaceSizes sizes() const noexcept {
        return {std::ssize(faces_), loops_, std::ssize(coedges_)};
    }
    // The size from the start of the first part to the end of the last one, padding included.
    [[nodiscard]] size_t size_in_bytes() const noexcept;
    void write(ByteWriter &writer) const noexcept;

private:
    struct FaceEntry {
        const face::Face *face;
        int64_t surface;
    };
    struct CoedgeEntry {
        const face::Coedge *coedge;
        int64_t curve, edge;
    };
    void write_loops(ByteWriter &writer) const noexcept;

    std::vector<FaceEntry> faces_;
    std::vector<CoedgeEntry> coedges_;
    int64_t loops_ = 0;
};

// Reads the faces of a body; their splines have to be known. A face is made from its loops in the directions
// that they had when it was first made, so that it gives the same answers bit for bit: loops that the face
// had turned are turned back, and the new face turns them again. The distances of curves that were made from
// edges are proven anew.
class FaceReader {
public:
    // Takes the three parts from `reader`, which moves on past them. Throws Status::truncated.
    FaceReader(ByteReader &reader, const FaceSizes &sizes);

    // The next face. Throws what ByteReader and Face throw, and Status::syntax, axes, dimension or tolerance
    // for numbers that no face has.
    [[nodiscard]] face::FacePtr next(const std::vector<SplinePtr> &splines);
    // Throws Status::syntax if there are loops or curves left, which belong to no face.
    void end() const;

private:
    [[nodiscard]] face::Coedge next_coedge(const std::vector<SplinePtr> &splines, int dim);

    ByteReader faces_, loops_, coedges_;
    FaceSizes left_;
};

} // namespace nrb::io
