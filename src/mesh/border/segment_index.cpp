// SPDX-License-Identifier: MIT
#include "mesh/border/segment_index.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

SegmentIndex::SegmentIndex(const FaceBorder &border) : border_(border) {
    box_.lower = {infinity, infinity};
    box_.upper = {-infinity, -infinity};
    for (const BorderPoint &point : border.points) {
        for (size_t k = 0; k < 2; ++k) {
            box_.lower[k] = std::min(box_.lower[k], point.param[k]);
            box_.upper[k] = std::max(box_.upper[k], point.param[k]);
        }
    }
    columns_ = std::clamp<size_t>(static_cast<size_t>(std::sqrt(static_cast<double>(border.segments.size()))),
                                  1, 1024);
    buckets_.resize(columns_ * columns_);
    for (int32_t i = 0; i < static_cast<int32_t>(border.segments.size()); ++i) {
        const BorderSegment &segment = border.segments[static_cast<size_t>(i)];
        const auto &a = border.points[static_cast<size_t>(segment.from)].param,
                   &b = border.points[static_cast<size_t>(segment.to)].param;
        const size_t u0 = column(0, std::min(a[0], b[0])), u1 = column(0, std::max(a[0], b[0])),
                     v0 = column(1, std::min(a[1], b[1])), v1 = column(1, std::max(a[1], b[1]));
        for (size_t u = u0; u <= u1; ++u) {
            for (size_t v = v0; v <= v1; ++v) {
                buckets_[u * columns_ + v].push_back(i);
            }
        }
    }
}

size_t SegmentIndex::column(size_t k, double x) const noexcept {
    // In a box without width the share is NaN or infinite, which no integer holds: all segments are then in
    // column 0.
    const double share = (x - box_.lower[k]) / box_.side(k) * static_cast<double>(columns_);
    return share > 0 ? static_cast<size_t>(std::min(share, static_cast<double>(columns_ - 1))) : 0;
}

// Tests for a separating axis: segment and rectangle are apart along an axis of the domain, or all corners of
// the rectangle are on one side of the line of the segment, by more than rounding.
bool SegmentIndex::meets(int32_t number, const Rectangle &part) const noexcept {
    const BorderSegment &segment = border_.segments[static_cast<size_t>(number)];
    const auto &a = border_.points[static_cast<size_t>(segment.from)].param,
               &b = border_.points[static_cast<size_t>(segment.to)].param;
    for (size_t k = 0; k < 2; ++k) {
        if (std::max(a[k], b[k]) < part.lower[k] || std::min(a[k], b[k]) > part.upper[k]) {
            return false;
        }
    }
    const double du = b[0] - a[0], dv = b[1] - a[1];
    bool left = false, right = false;
    for (size_t c = 0; c < 4; ++c) {
        const double u = (c % 2 == 0 ? part.lower[0] : part.upper[0]) - a[0],
                     v = (c < 2 ? part.lower[1] : part.upper[1]) - a[1];
        const double side = du * v - dv * u, noise = 8 * eps * (std::abs(du * v) + std::abs(dv * u));
        left = left || side >= -noise;
        right = right || side <= noise;
    }
    return left && right;
}

bool SegmentIndex::any_in(const Rectangle &part) const noexcept {
    if (border_.segments.empty()) {
        return false;
    }
    for (size_t k = 0; k < 2; ++k) {
        if (part.lower[k] > box_.upper[k] || part.upper[k] < box_.lower[k]) {
            return false;
        }
    }
    for (size_t u = column(0, part.lower[0]); u <= column(0, part.upper[0]); ++u) {
        for (size_t v = column(1, part.lower[1]); v <= column(1, part.upper[1]); ++v) {
            for (const int32_t i : buckets_[u * columns_ + v]) {
                if (meets(i, part)) {
                    return true;
                }
            }
        }
    }
    return false;
}

} // namespace nrb::mesh
