// SPDX-License-Identifier: MIT
// A part of the domain of a surface to which queries are restricted.
#pragma once

#include "closest/foot.h"
#include "pieces/bezier_piece.h"

namespace nrb::closest {

// The region of a face; its boundary belongs to it.
class Region {
public:
    Region() = default;
    Region(const Region &) = delete;
    Region &operator=(const Region &) = delete;
    virtual ~Region() = default;

    // 1 inside, 0 on the boundary to rounding, -1 outside.
    [[nodiscard]] virtual int side(const pieces::LocalParam &params) const = 0;
    // For a box of the domain: 1 if it is inside, -1 if it is outside, 0 if it may contain points of the
    // boundary.
    [[nodiscard]] virtual int side(const pieces::LocalParam &lower,
                                   const pieces::LocalParam &upper) const = 0;
    // The point of the region, boundary included, that is nearest to a point [dim]; any point of the region
    // if the limit of work is reached.
    [[nodiscard]] virtual BoundedFoot nearest(const double *point, double tolerance) = 0;
};

// The regions of two splines; null: the whole spline.
struct Regions {
    const Region *a = nullptr, *b = nullptr;
    bool boundaries = false; // whether nearest points on boundaries count
};

} // namespace nrb::closest
