// SPDX-License-Identifier: MIT
// The faces in a body: three parts, and splines in the table of what holds them.
//
//     of each face: its surface, the number of its loops, flags: 1 gaps are larger than the tolerance; its tolerance
//     of each loop: the number of its curves, flags: 1 the face was made with the loop backwards
//     of each curve: the curve, its edge or -1, the key of that, flags: 1 the edge runs against the curve, 2 their distance is
//         proven; that distance, else 0
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
    // Both have to outlive this.
    void add(const face::Face &face, SplineTable &splines);

    [[nodiscard]] FaceSizes sizes() const noexcept {
        return {std::ssize(faces_), loops_, std::ssize(coedges_)};
    }
    // From the beginning of a part to its end.
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

// The faces of a body, made once its splines are known. A face is made of its loops as it was before, so that it answers with the
// same bits: what was turned is turned back, and turned again. Distances of curves that were made are proven anew.
class FaceReader {
public:
    // Passes over the parts. Throws Status::truncated.
    FaceReader(ByteReader &reader, const FaceSizes &sizes);

    // The next face. Throws what ByteReader and Face do, and Status::syntax, axes, dimension for numbers that no face has.
    [[nodiscard]] face::FacePtr next(const std::vector<SplinePtr> &splines);
    // Throws Status::syntax where loops or curves are left that belong to no face.
    void end() const;

private:
    [[nodiscard]] face::Coedge next_coedge(const std::vector<SplinePtr> &splines, int dim);

    ByteReader faces_, loops_, coedges_;
    FaceSizes left_;
};

} // namespace nrb::io
