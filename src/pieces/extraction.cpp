// SPDX-License-Identifier: MIT
#include "pieces/extraction.h"

#include "refine/knots/axis_table.h"
#include "refine/parts/cut.h"

#include <algorithm>

namespace nrb::pieces {

LayerTable piece_rows(const KnotVector &axis, const std::vector<double> &breaks) {
    const std::vector<double> fine = refine::saturated(axis, breaks);
    const refine::Refinement refinement(axis.degree(), axis.knots(), fine);
    const int64_t first = std::lower_bound(fine.begin(), fine.end(), breaks.front()) - fine.begin();
    return refine::rows_of(refinement, first, first + (std::ssize(breaks) - 1) * (axis.degree() + 1));
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
