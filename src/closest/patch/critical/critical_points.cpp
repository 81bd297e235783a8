// SPDX-License-Identifier: MIT
#include "closest/patch/critical/critical_points.h"

#include <algorithm>

namespace nrb::closest {

bool CriticalPoints::has(const std::vector<double> &point) const {
    return places_.any_near(point.data(), [](int64_t) { return true; });
}

void CriticalPoints::add(const PatchItem &whole, const AxisValues &at, int32_t kind) {
    const PieceGrid &pieces = query_.pieces();
    AxisValues place{};
    for (int k = 0; k < query_.shape().axes; ++k) {
        place[static_cast<size_t>(k)] = std::clamp(whole.to_piece(k, at[static_cast<size_t>(k)]), 0.0, 1.0);
    }
    const double distance = query_.descent().distance(whole.values, at);
    CriticalPoint critical;
    critical.foot = foot_at(pieces, whole.piece, place, query_.query().range);
    critical.foot.distance = pieces.unscaled(distance);
    critical.foot.noise = pieces.unscaled(query_.noise());
    critical.kind = kind;
    candidates_.push_back({whole.piece, place, distance});
    found_.push_back(critical);
    points_.push_back(query_.point(whole, at));
    places_.add(points_.back().data());
}

std::vector<CriticalPoint> CriticalPoints::sorted() const {
    std::vector<CriticalPoint> result = found_;
    std::sort(result.begin(), result.end(),
              [](const CriticalPoint &a, const CriticalPoint &b) { return a.foot.params < b.foot.params; });
    return result;
}

} // namespace nrb::closest
