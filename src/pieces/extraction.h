// SPDX-License-Identifier: MIT
// How the Bezier points of a piece of an axis come from its control points.
#pragma once

#include "spline/layer_table.h"

#include <cstdint>
#include <vector>

namespace nrb::pieces {

// Breaks rise, in the domain, all knots between the first and the last among them. Axis and breaks must outlive
// this.
class PieceRows {
public:
    PieceRows(const KnotVector &axis, const std::vector<double> &breaks);

    // Rows [(e - first) * (degree + 1), ...) give the Bezier points of the piece after break e, first <= e < end.
    [[nodiscard]] LayerTable rows(int64_t first, int64_t end) const;

private:
    const KnotVector &axis_;
    const std::vector<double> &breaks_;
    bool own_; // the breaks are the ends of the axis's own spans
};

// The first of the degree + 1 layers that are active after each break but the last.
std::vector<int64_t> first_layers(const KnotVector &axis, const std::vector<double> &breaks);

} // namespace nrb::pieces
