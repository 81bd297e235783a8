// SPDX-License-Identifier: MIT
#include "analysis/curve_pieces.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"

#include <algorithm>

namespace nrb::analysis {

namespace {

constexpr size_t most_kept = 4096;
constexpr int64_t work_of_a_piece = 2000; // for its memory, in addition to that of its net

} // namespace

CurvePieces::CurvePieces(const Spline &curve)
    : curve_(curve), maker_(curve, whole_domain(curve)), kept_(std::min(count(), most_kept)) {}

const pieces::HomogeneousPiece &CurvePieces::piece(size_t e) {
    Kept &kept = e + 1 == count() ? last_ : kept_[e % kept_.size()];
    if (!kept.piece || kept.index != e) {
        count_work(work_of_a_piece);
        kept.piece.emplace(maker_.piece(static_cast<int64_t>(e)));
        kept.index = e;
    }
    return *kept.piece;
}

const pieces::HomogeneousPiece *CurvePieces::before(size_t e) {
    return e > 0 ? &piece(e - 1) : periodic() ? &piece(count() - 1) : nullptr;
}

int CurvePieces::order(size_t e) const noexcept {
    const KnotVector &axis = curve_.axis(0);
    return axis.degree() - multiplicity(axis.knots(), start(e));
}

double CurvePieces::jump(size_t e) const {
    if (order(e) >= 0) {
        return 0;
    }
    const double end_before = e > 0 ? start(e) : end(count() - 1);
    const std::vector<double> a = eval::curve_point(curve_, end_before, true),
                              b = eval::curve_point(curve_, start(e), false);
    const auto n = static_cast<int>(a.size());
    const double gap = distance(a.data(), b.data(), n);
    return gap > 4 * eps * (norm(a.data(), n) + norm(b.data(), n)) ? gap : 0;
}

} // namespace nrb::analysis
