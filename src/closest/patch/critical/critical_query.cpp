// SPDX-License-Identifier: MIT
#include "closest/patch/critical/critical_query.h"

#include "closest/patch/patch_query.h"
#include "numeric/norm.h"

namespace nrb::closest {

CriticalQuery::CriticalQuery(const PieceGrid &pieces, const Query &query)
    : pieces_(pieces), query_(query), items_(pieces, query.point, memory_),
      descent_(pieces.shape(), memory_) {
    noise_ = PatchQuery::scaled_noise(pieces, query.point);
    near_ = pieces.scaled(query.tolerance) + 64 * noise_;
}

PatchItem CriticalQuery::piece_in_range(int64_t piece) const {
    PatchItem whole = items_.whole(piece);
    items_.measure(whole);
    const PatchBox box = box_in_range(pieces_, piece, query_.range);
    for (int k = 0; k < shape().axes; ++k) {
        const auto at = static_cast<size_t>(k);
        if (box.lower[at] > 0 || box.upper[at] < 1) {
            whole = items_.part(whole, k, box.lower[at], box.upper[at]);
        }
    }
    return whole;
}

std::vector<double> CriticalQuery::point(const PatchItem &whole, const AxisValues &at) const {
    std::vector<double> result(static_cast<size_t>(shape().dim));
    descent_.point(whole.values, at, result.data());
    return result;
}

double CriticalQuery::apart(const std::vector<double> &a, const std::vector<double> &b) const noexcept {
    return distance(a.data(), b.data(), shape().dim);
}

} // namespace nrb::closest
