// SPDX-License-Identifier: MIT
#include "io/binary/face_bytes.h"

#include "io/binary/checked_numbers.h"

namespace nrb::io {

FaceBytes::FaceBytes(const face::Face &face) {
    face_.add(face, splines_);
    size_ = 2 * header_size + face_.size_in_bytes() + splines_.size_in_bytes();
}

void FaceBytes::write(std::span<unsigned char> out) const noexcept {
    ByteWriter writer(Kind::face, {}, out);
    writer.put(face_.sizes().loops);
    writer.put(face_.sizes().coedges);
    writer.put(splines_.count());
    writer.align();
    face_.write(writer);
    splines_.write(writer);
    writer.finish();
}

face::FacePtr face_from(std::span<const unsigned char> bytes) {
    ByteReader reader(bytes, Kind::face);
    FaceSizes sizes{1, 0, 0};
    sizes.loops = size_from(reader, "number of loops");
    sizes.coedges = size_from(reader, "number of curves");
    const int64_t count = size_from(reader, "number of splines");
    reader.align();
    FaceReader faces(reader, sizes);
    const std::vector<SplinePtr> splines = splines_from(reader, count);
    reader.end();
    face::FacePtr face = faces.next(splines);
    faces.end();
    return face;
}

} // namespace nrb::io
