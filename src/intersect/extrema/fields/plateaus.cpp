// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/plateaus.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace nrb::intersect {

namespace {

// What boxes have in common that may lie side by side along axis k.
auto apart_from(const Extremum &x, int k) noexcept {
    Part others = x.range;
    others[static_cast<size_t>(k)] = {};
    return std::tuple(x.kinds, x.value, others[0].lower, others[0].upper, others[1].lower, others[1].upper,
                      others[2].lower, others[2].upper);
}

std::vector<Extremum> merged_along(std::vector<Extremum> boxes, int k) {
    const auto at = static_cast<size_t>(k);
    std::ranges::sort(boxes, {},
                      [=](const Extremum &x) { return std::pair(apart_from(x, k), x.range[at].lower); });
    std::vector<Extremum> result;
    for (const Extremum &box : boxes) {
        if (!result.empty() && apart_from(result.back(), k) == apart_from(box, k) &&
            result.back().range[at].upper == box.range[at].lower) {
            Extremum &last = result.back();
            last.range[at].upper = box.range[at].upper;
            last.at[at] = last.range[at].lower / 2 + last.range[at].upper / 2;
        } else {
            result.push_back(box);
        }
    }
    return result;
}

} // namespace

bool ends_plateau(const GradientField &field, const Stratum &stratum, const PieceIndex &index) {
    for (int k = 0; k < field.axes(); ++k) {
        if (!stratum.is_fixed(k)) {
            continue;
        }
        const Sides sides = stratum.freed(k).sides();
        const bool kink = field.joint(k, stratum.axes[static_cast<size_t>(k)].joint) == JointKind::kink;
        if (field.constants(index, sides).all ||
            (kink && field.constants(across(field, stratum, index, k), sides).all)) {
            return true;
        }
    }
    return false;
}

std::vector<Extremum> merged(std::vector<Extremum> boxes, int axes) {
    for (int k = axes; k-- > 0;) {
        boxes = merged_along(std::move(boxes), k);
    }
    return boxes;
}

} // namespace nrb::intersect
