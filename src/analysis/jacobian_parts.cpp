// SPDX-License-Identifier: MIT
#include "analysis/jacobian_parts.h"

#include "pieces/best_first.h"

#include <algorithm>

namespace nrb::analysis {

BoundaryZeros divide_boundaries(RoundedPolynomial &f, int axes) {
    BoundaryZeros divided{};
    for (int k = 0; k < axes && !vanishes(f); ++k) {
        for (const bool upper : {false, true}) {
            const int axis = max_axes - axes + k;
            divided[static_cast<size_t>(k)][upper ? 1 : 0] = divide_end(f, axis, upper) > 0;
        }
    }
    return divided;
}

bool halve_longest(JacobianPart &part, int axes, const std::array<double, max_axes> &scale, double least,
                   JacobianPart &lower) {
    int longest = -1;
    double most = least;
    for (int k = 0; k < axes; ++k) {
        const auto at = static_cast<size_t>(k);
        const double length = (part.to[at] - part.from[at]) * scale[at];
        if (length > most && part.f.shape.degrees[static_cast<size_t>(max_axes - axes + k)] > 0) {
            most = length;
            longest = k;
        }
    }
    if (longest < 0) {
        return false;
    }
    const auto at = static_cast<size_t>(longest);
    const double middle = part.from[at] / 2 + part.to[at] / 2;
    lower = {split(part.f, max_axes - axes + longest), part.piece, part.from, part.to};
    lower.to[at] = middle;
    part.from[at] = middle;
    return true;
}

int64_t halvings_for(const RoundedPolynomial &f) noexcept {
    constexpr int64_t room = int64_t{1} << 25; // doubles
    return std::min(pieces::default_budget, room / std::max<int64_t>(1, f.shape.values()));
}

} // namespace nrb::analysis
