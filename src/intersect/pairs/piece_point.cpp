// SPDX-License-Identifier: MIT
#include "intersect/pairs/piece_point.h"

#include "bernstein/de_casteljau.h"

namespace nrb::intersect {

// The last level but one of de Casteljau's algorithm yields both: the value between two records, and the
// derivative as their difference times the degree.
void PiecePoint::evaluate(const pieces::BezierPiece &piece, double place) {
    const int p = piece.degree(0), dim = piece.dim(), width = dim + 1;
    records_.assign(piece.record(0), piece.record(p + 1));
    for (int level = p; level > 1; --level) {
        casteljau_step(int64_t{level} * width, width, place, records_.data());
    }
    value_.resize(static_cast<size_t>(dim));
    derivative_.assign(static_cast<size_t>(dim), 0.0);
    const double *from = records_.data(), *to = p > 0 ? from + width : from;
    const double w = (1 - place) * from[dim] + place * to[dim], slope_of_w = p * (to[dim] - from[dim]);
    for (size_t c = 0; c < value_.size(); ++c) {
        value_[c] = ((1 - place) * from[c] + place * to[c]) / w;
        derivative_[c] = (p * (to[c] - from[c]) - value_[c] * slope_of_w) / w;
    }
}

} // namespace nrb::intersect
