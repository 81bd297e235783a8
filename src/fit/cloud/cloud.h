// SPDX-License-Identifier: MIT
// Points without parameters.
#pragma once

#include "base/records.h"
#include "numeric/double_double.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::fit {

// The points that count, in the order of their coordinates: what is made of them, sums included, does not depend on the
// order in which they were given. Coordinates and weights are in units of powers of two that none exceeds, so that squares
// neither overflow nor vanish. Coordinates are those from an origin amid points that are far from 0 beside their extent, so
// that these are not lost in rounding; from 0 otherwise. No coordinate is rounded by that.
struct Cloud {
    int dim;
    int exponent, weight_exponent;
    std::vector<double> origin;   // [dim], of the caller
    std::vector<double> points;   // [size][dim]
    std::vector<double> weights;  // [size]
    std::vector<int64_t> indices; // of the caller

    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(weights.size()); }
    [[nodiscard]] const double *point(int64_t i) const noexcept { return points.data() + i * dim; }
    [[nodiscard]] double weight() const noexcept;
    // A coordinate of the caller, and what it is here.
    [[nodiscard]] double given(double x, size_t c) const noexcept {
        return std::ldexp(x, exponent) + origin[c];
    }
    [[nodiscard]] double own(double x, size_t c) const noexcept {
        return std::ldexp(x - origin[c], -exponent);
    }
    // Some of the points, in that order.
    [[nodiscard]] Cloud part(const std::vector<int64_t> &which) const;
    // Whether coordinates are not those from 0.
    [[nodiscard]] bool moved() const noexcept;
};

// Points of weight 0 are left out, whatever they are; the control points of a `start` [..][dim] have their place beside the
// others. Throws Status::point_not_finite, weight_not_finite and weight_negative with the first index, and Status::count where
// no point counts.
Cloud cloud_of(const ConstRecords &points, const ConstRecords &weights, std::span<const double> start = {});

} // namespace nrb::fit
