// SPDX-License-Identifier: MIT
#include "basis/power_spans.h"

#include "basis/knot_vector.h"

#include <algorithm>
#include <limits>

namespace nrb::inline basis {

PieceArray::PieceArray(int64_t count, int64_t size) : size_(size) {
    constexpr size_t line = 64 / sizeof(double);
    storage_.resize(static_cast<size_t>(count * size) + line - 1);
    const size_t offset = reinterpret_cast<uintptr_t>(storage_.data()) / sizeof(double) % line;
    first_ = storage_.data() + (line - offset) % line;
}

PieceArray basis_pieces(const KnotVector &axis) {
    const SpanTable &spans = axis.spans();
    PieceArray pieces(spans.size(), Piece::size(axis.degree(), axis.degree() + 1));
    for (int64_t first = 0; first < spans.size(); first += pieces_together()) {
        const auto count = static_cast<int>(std::min<int64_t>(pieces_together(), spans.size() - first));
        double *together[most_pieces_together];
        for (int l = 0; l < count; ++l) {
            together[l] = pieces[first + l];
        }
        basis_pieces(axis.knots().data(), axis.degree(), spans.indices().data() + first, count, together,
                     nullptr);
        for (int l = 0; l < count; ++l) {
            if (!axis.has_piece(spans.indices()[static_cast<size_t>(first + l)])) {
                std::fill_n(together[l], static_cast<int>(Piece::head_size),
                            std::numeric_limits<double>::quiet_NaN());
            }
        }
    }
    return pieces;
}

} // namespace nrb::inline basis
