// SPDX-License-Identifier: MIT
// The binary form of a face.
#pragma once

#include "io/binary/face_table.h"

namespace nrb::io {

// The body, each part at a multiple of 64 bytes:
//
//     64   numbers of loops, of their curves, and of distinct splines
//     128  the face, its loops and their curves: see face_table.h
//          the splines: see spline_table.h
class FaceBytes {
public:
    // The face must outlive this object.
    explicit FaceBytes(const face::Face &face);

    [[nodiscard]] size_t size() const noexcept { return size_; }
    // Precondition: `out` has size() bytes.
    void write(std::span<unsigned char> out) const noexcept;

private:
    SplineTable splines_;
    FaceTable face_;
    size_t size_;
};

// Throws what ByteReader, spline_from() and FaceReader throw.
face::FacePtr face_from(std::span<const unsigned char> bytes);

} // namespace nrb::io
