// SPDX-License-Identifier: MIT
// Bounds of derivatives over parts of a piece of a surface, and of a function over it.
#pragma once

#include "intersect/levels/trace/level_net.h"
#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::intersect {

// Of f = h / w: what holds on a part of [0, 1]^2.
struct PartBounds {
    double least_slope = 0; // of h along an axis; 0: it has no sign for certain
    double least_weight = 1,
           largest_weight = 1;     // of coefficients; the derivative of the surface is bounded if > 0
    std::array<double, 2> moves{}; // of |S_k|
};

// Derivatives are taken of the coefficients of the whole piece, since differences on small parts have few digits.
class PieceBounds {
public:
    // records: [degrees[0] + 1][degrees[1] + 1][4] of points with their weights.
    void set(const LevelNet &net, const std::array<int, 2> &degrees, std::vector<double> records);
    [[nodiscard]] PartBounds over(const std::array<Interval, 2> &box, size_t axis) const;

private:
    [[nodiscard]] double least_slope(const std::array<Interval, 2> &box, size_t axis) const;

    std::array<int, 2> degrees_{}, degrees_of_f_{};
    std::vector<double> records_;
    // Along each axis: of h, of what is known of it, and of records.
    std::array<std::vector<double>, 2> slopes_, rooms_, moves_;
};

} // namespace nrb::intersect
