// SPDX-License-Identifier: MIT
// Shape constraints: splines that rise or fall, are convex or concave along their axes, or stay between
// bounds.
#pragma once

#include "fit/constraints/linear_rows.h"

#include <vector>

namespace nrb::fit {

// Constraints on the control points, which are sufficient for the spline: by the convex hull property,
// derivatives are convex combinations of their control points. Convexity means that the slopes between
// control points increase, at kinks as well.
struct ShapeWishes {
    static constexpr int rising = 1, falling = 2, convex = 4, concave = 8;
    std::vector<int> along;           // [axes][dim] sums of these, or empty
    std::vector<double> lower, upper; // [dim] or empty, may be infinite

    [[nodiscard]] bool empty() const noexcept { return along.empty() && lower.empty() && upper.empty(); }
};

// Throws Status::rule for a shape that only a constant or a line has, or along a periodic axis; Status::order
// for a convex or concave axis of degree 0; Status::multiplicity for one that may jump at a knot;
// Status::contradiction for bounds that cross.
void check_shape(const std::vector<KnotVectorPtr> &axes, int dim, const ShapeWishes &wishes);

// For each axis, how many layers apart the control points of an inequality are: 2 for convexity, 1 for
// monotonicity.
Index shape_reach(const std::vector<KnotVectorPtr> &axes, const ShapeWishes &wishes);

// The shape of one coordinate of a spline, over the distinct layers of the axes.
class CoordinateShape {
public:
    CoordinateShape(const std::vector<KnotVectorPtr> &axes, int dim, const ShapeWishes &wishes,
                    int coordinate);

    [[nodiscard]] bool empty() const noexcept;
    // The inequalities for control points; those of convexity with a margin, and no bounds of a magnitude
    // above `limit`.
    [[nodiscard]] std::vector<LinearRow> rows(double margin, double limit) const;
    // Restores rising, falling and bounds where rounding has violated them.
    void settle(std::vector<double> &points) const;
    // Whether the shape is proven for exactly these numbers.
    [[nodiscard]] bool holds(const std::vector<double> &points) const;

private:
    // Calls visit(index of the first layer) for each run of `layers` consecutive layers along an axis.
    template <class Visit>
    void for_each_run(size_t axis, int64_t layers, Visit &&visit) const;
    void add_row(size_t axis, const Index &first, const std::vector<double> &values, double least,
                 std::vector<LinearRow> &rows) const;
    [[nodiscard]] bool is_convex(size_t axis, const Index &first, int64_t step,
                                 const std::vector<double> &points) const;
    [[nodiscard]] int64_t number(const Index &layer) const noexcept;

    std::vector<KnotVectorPtr> axes_;
    std::vector<int> along_; // of each axis
    double lower_, upper_;
    Index counts_{1, 1, 1};
};

} // namespace nrb::fit
