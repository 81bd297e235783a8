// SPDX-License-Identifier: MIT
#include "pieces/extraction.h"

#include "refine/knots/axis_table.h"
#include "refine/knots/bezier_rows.h"
#include "refine/parts/cut.h"

#include <algorithm>

namespace nrb::pieces {

namespace {

// The knots of all layers that are active on a part of the domain.
std::span<const double> active_knots(const KnotVector &axis, double lower, double upper) {
    const std::span<const double> knots = axis.knots();
    const auto order = axis.degree() + 1;
    const auto first = std::upper_bound(knots.begin() + order, knots.end() - order, lower) - order;
    const auto last = std::lower_bound(first + order, knots.end() - order, upper);
    return {first, last + order};
}

} // namespace

PieceRows::PieceRows(const KnotVector &axis, const std::vector<double> &breaks)
    : axis_(axis), breaks_(breaks), own_(std::ranges::equal(breaks, axis.spans().breaks())) {}

LayerTable PieceRows::rows(int64_t first, int64_t end) const {
    if (own_) {
        return refine::bezier_rows(axis_, first, end);
    }
    const int p = axis_.degree();
    const std::span<const double> part(breaks_.data() + first, static_cast<size_t>(end - first) + 1);
    const std::span<const double> knots = active_knots(axis_, part.front(), part.back());
    const std::vector<double> fine = refine::saturated(p, knots, part);
    const refine::Refinement refinement(p, knots, fine);
    const int64_t row = std::lower_bound(fine.begin(), fine.end(), part.front()) - fine.begin();
    LayerTable table = refine::rows_of(refinement, row, row + (end - first) * (p + 1));
    table.shift(knots.data() - axis_.knots().data());
    return table;
}

std::vector<int64_t> first_layers(const KnotVector &axis, const std::vector<double> &breaks) {
    std::vector<int64_t> first;
    int64_t span = axis.degree();
    for (size_t e = 0; e + 1 < breaks.size(); ++e) {
        while (span + 1 < axis.count() && axis[span + 1] <= breaks[e]) {
            ++span;
        }
        first.push_back(span - axis.degree());
    }
    return first;
}

} // namespace nrb::pieces
