// SPDX-License-Identifier: MIT
// Bezier extraction: the Bezier points of the pieces of an axis as combinations of control points.
#pragma once

#include "spline/layer_table.h"

#include <cstdint>
#include <vector>

namespace nrb::pieces {

// The breaks increase, lie in the domain, and include all knots between the first and the last. Axis and
// breaks must outlive this object.
class PieceRows {
public:
    PieceRows(const KnotVector &axis, const std::vector<double> &breaks);

    // Rows [(e - first) * (degree + 1), ...) give the Bezier points of the piece that starts at break e,
    // first <= e < end.
    [[nodiscard]] LayerTable rows(int64_t first, int64_t end) const;

private:
    const KnotVector &axis_;
    const std::vector<double> &breaks_;
    bool own_; // the breaks are those of the axis itself
};

// For each break but the last, the first of the degree + 1 layers that are active after it.
std::vector<int64_t> first_layers(const KnotVector &axis, const std::vector<double> &breaks);

} // namespace nrb::pieces
