// SPDX-License-Identifier: MIT
// The binary form of a list of splines, with names, notes and unit.
#pragma once

#include "io/binary/spline_table.h"
#include "io/binary/texts.h"

namespace nrb::io {

// The body, each part at a multiple of 64 bytes:
//
//     64   numbers of entries of the list, of distinct splines, of notes, and of bytes of text;
//          metres per unit, a double
//     128  for each entry: its spline
//          for each note: its entity type, line and reason
//          where each text ends, counted from the start of the texts: the names, then the texts of the notes
//          the texts
//          the splines: see spline_table.h
//
// All numbers have 64 bits. Lists of the same splines, names, notes and unit have the same bytes.
class ListBytes {
public:
    // The model must outlive this object.
    explicit ListBytes(const model::Model &model);

    [[nodiscard]] size_t size() const noexcept { return size_; }
    // Precondition: `out` has size() bytes.
    void write(std::span<unsigned char> out) const noexcept;

private:
    const model::Model &model_;
    SplineTable table_;
    std::vector<int64_t> indices_;
    Texts texts_;
    size_t size_;
};

// Throws what ByteReader and spline_from() throw, and Status::syntax or factor for numbers that no list has.
model::Model list_from(std::span<const unsigned char> bytes);

} // namespace nrb::io
