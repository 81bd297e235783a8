// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/field_box.h"

#include "base/numbers.h"

#include <algorithm>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr double widened = 8 * eps;

// The pieces along one axis that an interval of a piece's coordinate meets.
struct AxisPart {
    int64_t index;
    Interval place;
    double scale;
};

Interval wide(double lower, double upper) noexcept {
    return {std::max(lower - widened, 0.0), std::min(upper + widened, 1.0)};
}

class AxisCover {
public:
    AxisCover(const GradientField &field, int k, int64_t home) : field_(field), k_(k), home_(home) {}

    // No parts if the interval reaches too far.
    std::vector<AxisPart> operator()(Interval x) {
        if (x.upper >= 0 && x.lower <= 1) {
            parts_.push_back({home_, wide(x.lower, x.upper), 1});
        }
        if (x.lower < 0) {
            add(field_.beside(k_, home_, false), home_, -std::min(x.upper, 0.0), -x.lower, false);
        }
        if (x.upper > 1) {
            add(field_.beside(k_, home_ + 1, true), home_ + 1, std::max(x.lower, 1.0) - 1, x.upper - 1, true);
        }
        return enough_ ? std::move(parts_) : std::vector<AxisPart>{};
    }

private:
    // From and to in distances from a joint.
    void add(int64_t index, int64_t joint, double from, double to, bool up) {
        const double scale = length(home_) / length(index);
        enough_ = enough_ && field_.joint(k_, joint) == JointKind::smooth && to * scale < 1;
        const Interval place = wide(from * scale, to * scale);
        parts_.push_back({index, up ? place : Interval{1 - place.upper, 1 - place.lower}, scale});
    }
    [[nodiscard]] double length(int64_t i) const noexcept {
        return field_.parameter(k_, i + 1) - field_.parameter(k_, i);
    }

    const GradientField &field_;
    int k_;
    int64_t home_;
    bool enough_ = true;
    std::vector<AxisPart> parts_;
};

} // namespace

std::optional<std::vector<CoveredPart>> covered(const GradientField &field, const Stratum &stratum,
                                                const PieceIndex &home, const Part &box) {
    std::vector<CoveredPart> list{{home, nullptr}};
    for (int k = 0; k < field.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        if (stratum.is_fixed(k)) {
            continue;
        }
        const std::vector<AxisPart> along = AxisCover(field, k, home[at])(box[at]);
        std::vector<CoveredPart> longer;
        for (const AxisPart &part : along) {
            for (CoveredPart covered : list) {
                covered.index[at] = part.index;
                covered.box[at] = part.place;
                covered.scale[at] = part.scale;
                longer.push_back(covered);
            }
        }
        list = std::move(longer);
    }
    const GradientPiecePtr own = field.piece(home);
    for (CoveredPart &part : list) {
        part.piece = field.piece(part.index);
        part.exponent = part.piece->exponent - own->exponent;
        if (!part.piece->piece.positive) {
            return std::nullopt;
        }
    }
    return list.empty() ? std::nullopt : std::optional(std::move(list));
}

Interval range_over(RoundedPolynomial f, const CoveredPart &part, const Stratum &stratum, int axes) {
    for (int k = 0; k < axes; ++k) {
        const auto [lower, upper] = part.box[static_cast<size_t>(k)];
        const int axis = part.piece->piece.axis(k);
        if (stratum.is_fixed(k) || f.shape.degrees[static_cast<size_t>(axis)] == 0) {
            continue;
        }
        if (upper < 1) {
            f = split(f, axis, upper);
        }
        if (lower > 0) {
            split(f, axis, std::max(lower / std::max(upper, lower) - eps, 0.0));
        }
    }
    Interval range = nothing;
    for (size_t i = 0; i < f.values.size(); ++i) {
        range = hull(range, {f.values[i] - f.error(i), f.values[i] + f.error(i)});
    }
    return range;
}

int slope_sign(const CoveredPart &part, const Stratum &stratum, int axes, int k) {
    const auto at = static_cast<size_t>(k);
    RoundedPolynomial slope = part.piece->slopes[at];
    if (stratum.is_fixed(k)) {
        const bool upper = stratum.upper_end(k);
        const int layers = part.piece->constants.layers[at][upper ? 1 : 0];
        divide_end(slope, part.piece->piece.axis(k), upper, layers - 1);
    }
    const Interval range =
        range_over(on_stratum(std::move(slope), part.piece->piece, stratum, axes), part, stratum, axes);
    return range.lower > 0 ? 1 : range.upper < 0 ? -1 : 0;
}

} // namespace nrb::intersect
