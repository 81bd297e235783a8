// SPDX-License-Identifier: MIT
#include "closest/patch/patch_place.h"

#include <algorithm>

namespace nrb::closest {

PatchBox box_in_range(const PieceGrid &pieces, int64_t piece, const Interval *range) noexcept {
    PatchBox result;
    if (range == nullptr) {
        return result;
    }
    const PieceGrid::Index index = pieces.index(piece);
    for (int k = 0; k < pieces.shape().axes; ++k) {
        const int axis = pieces.spline_axis(k);
        const int64_t i = index[static_cast<size_t>(axis)];
        const double first = pieces.break_at(axis, i), length = pieces.break_at(axis, i + 1) - first;
        const auto at = static_cast<size_t>(k);
        result.lower[at] = std::clamp((range[axis].lower - first) / length, 0.0, 1.0);
        result.upper[at] = std::clamp((range[axis].upper - first) / length, 0.0, 1.0);
    }
    return result;
}

int32_t boundary_bit(const PieceGrid &pieces, const Foot &foot, const Interval *range) noexcept {
    for (int axis = 0; axis < pieces.spline_axes(); ++axis) {
        const double t = foot.params[static_cast<size_t>(axis)];
        const double first = pieces.break_at(axis, 0), last = pieces.break_at(axis, pieces.count(axis));
        const Interval part = range != nullptr ? range[axis] : Interval{first, last};
        const bool whole = part.lower == first && part.upper == last;
        if ((t == part.lower || t == part.upper) && !(whole && pieces.periodic(axis))) {
            return closest_boundary;
        }
    }
    return 0;
}

Foot foot_at(const PieceGrid &pieces, int64_t piece, const AxisValues &at, const Interval *range) noexcept {
    Foot foot;
    const PieceGrid::Index index = pieces.index(piece);
    std::array<int, max_axes> shape_axis{};
    shape_axis.fill(-1);
    for (int k = 0; k < pieces.shape().axes; ++k) {
        shape_axis[static_cast<size_t>(pieces.spline_axis(k))] = k;
    }
    for (int axis = 0; axis < pieces.spline_axes(); ++axis) {
        const auto i = static_cast<size_t>(axis);
        const double first = pieces.break_at(axis, index[i]), last = pieces.break_at(axis, index[i] + 1);
        double low = first, high = last;
        if (range != nullptr) {
            low = std::max(low, range[axis].lower);
            high = std::min(high, range[axis].upper);
        }
        const double s = shape_axis[i] < 0 ? -1 : at[static_cast<size_t>(shape_axis[i])];
        const double t = s < 0 ? low / 2 + high / 2 : s == 1 ? last : first + s * (last - first);
        foot.params[i] = std::clamp(t, low, high);
        // At the end of the domain, the limit from below is taken anyway.
        const bool inside = index[i] + 1 < pieces.count(axis);
        if (inside && foot.params[i] == last && pieces.jumps(axis, index[i] + 1)) {
            foot.left |= 1U << i;
        }
    }
    foot.status = boundary_bit(pieces, foot, range);
    return foot;
}

bool near_params(const PieceGrid &pieces, const Foot &a, const Foot &b) noexcept {
    bool near = true;
    for (int axis = 0; axis < pieces.spline_axes(); ++axis) {
        const auto i = static_cast<size_t>(axis);
        const double lower = pieces.break_at(axis, 0), upper = pieces.break_at(axis, pieces.count(axis));
        near = near && std::abs(a.params[i] - b.params[i]) <= 0x1p-40 * (upper - lower);
    }
    return near;
}

} // namespace nrb::closest
