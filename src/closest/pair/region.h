// SPDX-License-Identifier: MIT
// A part of a surface that counts alone.
#pragma once

#include "closest/foot.h"
#include "pieces/bezier_piece.h"

namespace nrb::closest {

// The region of a face, with its boundary.
class Region {
public:
    Region() = default;
    Region(const Region &) = delete;
    Region &operator=(const Region &) = delete;
    virtual ~Region() = default;

    // 1 inside, 0 on the boundary to rounding, -1 outside.
    [[nodiscard]] virtual int side(const pieces::LocalParam &params) const = 0;
    // Of a box of the domain: 1 if it is inside, -1 if it is outside, 0 if the boundary may come into it.
    [[nodiscard]] virtual int side(const pieces::LocalParam &lower,
                                   const pieces::LocalParam &upper) const = 0;
    // The point of the region, boundary and all, that is nearest to a point [dim]; some point of it at the limit of work.
    [[nodiscard]] virtual BoundedFoot nearest(const double *point, double tolerance) = 0;
};

// Of two splines; null: all of it.
struct Regions {
    const Region *a = nullptr, *b = nullptr;
    bool boundaries = false; // whether nearest points on boundaries count, too
};

} // namespace nrb::closest
