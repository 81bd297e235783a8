// SPDX-License-Identifier: MIT
// The critical points that a search has found, without duplicates.
#pragma once

#include "closest/locator.h"
#include "closest/near_points.h"
#include "closest/patch/critical/critical_query.h"

#include <vector>

namespace nrb::closest {

// A place in a piece at which the distance may have a minimum.
struct MinimumCandidate {
    int64_t piece;
    AxisValues at;
    double distance;
    bool certain = false; // it is a minimum, by the second derivatives in all adjacent pieces
};

class CriticalPoints {
public:
    explicit CriticalPoints(const CriticalQuery &query)
        : query_(query), places_(query.shape().dim, query.near()) {}

    // Whether `point`, which is at this place of a piece, coincides to the tolerance with a point that was
    // found.
    [[nodiscard]] bool has(const std::vector<double> &point, const PatchItem &whole,
                           const AxisValues &at) const;
    [[nodiscard]] bool full() const noexcept { return found_.size() >= 4096; }
    // Adds the point at a place of the part of a piece that lies in the range.
    void add(const PatchItem &whole, const AxisValues &at, int32_t kind);

    [[nodiscard]] size_t size() const noexcept { return found_.size(); }
    [[nodiscard]] const std::vector<double> &point(size_t i) const noexcept { return points_[i]; }
    [[nodiscard]] const MinimumCandidate &candidate(size_t i) const noexcept { return candidates_[i]; }
    // In the order of their parameters.
    [[nodiscard]] std::vector<CriticalPoint> sorted() const;

private:
    [[nodiscard]] Foot foot(const PatchItem &whole, const AxisValues &at) const noexcept;

    const CriticalQuery &query_;
    std::vector<CriticalPoint> found_;
    std::vector<MinimumCandidate> candidates_; // parallel to found_
    std::vector<std::vector<double>> points_;  // parallel to found_
    NearPoints places_;                        // the same points, for has()
};

} // namespace nrb::closest
