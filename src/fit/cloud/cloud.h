// SPDX-License-Identifier: MIT
// Points without parameters.
#pragma once

#include "base/records.h"
#include "numeric/double_double.h"

#include <cstdint>
#include <vector>

namespace nrb::fit {

// The points that count, in the order of their coordinates: what is made of them, sums included, does not depend on the
// order in which they were given. Coordinates and weights are in units of powers of two that none exceeds, so that squares
// neither overflow nor vanish.
struct Cloud {
    int dim;
    int exponent, weight_exponent;
    std::vector<double> points;   // [size][dim]
    std::vector<double> weights;  // [size]
    std::vector<int64_t> indices; // of the caller

    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(weights.size()); }
    [[nodiscard]] const double *point(int64_t i) const noexcept { return points.data() + i * dim; }
    [[nodiscard]] double weight() const noexcept;
};

// Points of weight 0 are left out, whatever they are. `least` is a size that the unit of coordinates is not below. Throws
// Status::point_not_finite, weight_not_finite and weight_negative with the first index, and Status::count where no point
// counts.
Cloud cloud_of(const ConstRecords &points, const ConstRecords &weights, double least = 0);

} // namespace nrb::fit
