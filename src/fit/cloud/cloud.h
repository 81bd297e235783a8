// SPDX-License-Identifier: MIT
// Point clouds: points without parameters.
#pragma once

#include "base/records.h"
#include "numeric/double_double.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::fit {

// The points that count, sorted by their coordinates: results, sums included, do not depend on the order in
// which they were given. Coordinates and weights are in units of powers of two that none of them exceeds, so
// that squares neither overflow nor vanish. Where the points are far from 0 relative to their extent,
// coordinates are relative to an origin amid the points, so that the extent is not lost in rounding;
// otherwise they are relative to 0. The change of origin does not round any coordinate.
struct Cloud {
    int dim;
    int exponent, weight_exponent;
    std::vector<double> origin;   // [dim], in coordinates of the caller
    std::vector<double> points;   // [size][dim]
    std::vector<double> weights;  // [size]
    std::vector<int64_t> indices; // [size], indices of the caller

    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(weights.size()); }
    [[nodiscard]] const double *point(int64_t i) const noexcept { return points.data() + i * dim; }
    [[nodiscard]] double weight() const noexcept;
    // given(): the caller's value of a coordinate of the cloud; own(): the reverse.
    [[nodiscard]] double given(double x, size_t c) const noexcept {
        return std::ldexp(x, exponent) + origin[c];
    }
    [[nodiscard]] double own(double x, size_t c) const noexcept {
        return std::ldexp(x - origin[c], -exponent);
    }
    // The points `which`, in that order.
    [[nodiscard]] Cloud part(const std::vector<int64_t> &which) const;
    // Whether the origin is not 0.
    [[nodiscard]] bool moved() const noexcept;
};

// Points of weight 0 are left out, whatever their coordinates. The origin and the units also suit the control
// points `start` [..][dim]. Throws Status::point_not_finite, weight_not_finite and weight_negative with the
// first index, and Status::count where no point counts.
Cloud cloud_of(const ConstRecords &points, const ConstRecords &weights, std::span<const double> start = {});

} // namespace nrb::fit
