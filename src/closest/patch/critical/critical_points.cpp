// SPDX-License-Identifier: MIT
#include "closest/patch/critical/critical_points.h"

#include <algorithm>

namespace nrb::closest {

namespace {

AxisValues in_piece(const CriticalQuery &query, const PatchItem &whole, const AxisValues &at) noexcept {
    AxisValues place{};
    for (int k = 0; k < query.shape().axes; ++k) {
        place[static_cast<size_t>(k)] = std::clamp(whole.to_piece(k, at[static_cast<size_t>(k)]), 0.0, 1.0);
    }
    return place;
}

} // namespace

Foot CriticalPoints::foot(const PatchItem &whole, const AxisValues &at) const noexcept {
    return foot_at(query_.pieces(), whole.piece, in_piece(query_, whole, at), query_.query().range);
}

bool CriticalPoints::has(const std::vector<double> &point, const PatchItem &whole,
                         const AxisValues &at) const {
    const bool sheets = query_.query().sheets;
    const Foot own = sheets ? foot(whole, at) : Foot{};
    return places_.any_near(point.data(), [&](int64_t number) {
        return !sheets || near_params(query_.pieces(), found_[static_cast<size_t>(number)].foot, own);
    });
}

void CriticalPoints::add(const PatchItem &whole, const AxisValues &at, int32_t kind) {
    const PieceGrid &pieces = query_.pieces();
    const AxisValues place = in_piece(query_, whole, at);
    const double distance = query_.descent().distance(whole.values, at);
    CriticalPoint critical;
    critical.foot = foot(whole, at);
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
