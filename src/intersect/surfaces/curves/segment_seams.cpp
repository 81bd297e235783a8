// SPDX-License-Identifier: MIT
#include "intersect/surfaces/curves/segment_seams.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

bool is_seam(const CrossSurface &a, const CrossSurface &b, const CrossSegment &before,
             const CrossSegment &after) noexcept {
    for (size_t i = 0; i < 4; ++i) {
        const SurfaceBorders &borders = (i < 2 ? a : b).borders;
        const double far = std::abs(before.on[i / 2][3][i % 2] - after.on[i / 2][0][i % 2]);
        if (!borders.is_periodic(i % 2) && borders.wraps(i % 2) && far > borders.period(i % 2) / 2) {
            return true;
        }
    }
    return false;
}

std::vector<std::vector<CrossSegment>> parts_between_seams(const CrossSurface &a, const CrossSurface &b,
                                                           std::vector<CrossSegment> segments, bool closed) {
    for (size_t i = 0; closed && i < segments.size(); ++i) {
        if (is_seam(a, b, segments[i == 0 ? segments.size() - 1 : i - 1], segments[i])) {
            std::rotate(segments.begin(), segments.begin() + static_cast<std::ptrdiff_t>(i), segments.end());
            break;
        }
    }
    std::vector<std::vector<CrossSegment>> parts(1);
    for (size_t i = 0; i < segments.size(); ++i) {
        if (i > 0 && is_seam(a, b, segments[i - 1], segments[i])) {
            parts.emplace_back();
        }
        parts.back().push_back(segments[i]);
    }
    return parts;
}

} // namespace nrb::intersect
