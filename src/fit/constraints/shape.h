// SPDX-License-Identifier: MIT
// Splines that rise or fall, are convex or concave along their axes, or stay between bounds.
#pragma once

#include "fit/constraints/linear_rows.h"

#include <vector>

namespace nrb::fit {

// What the control points are to fulfil, which is enough for the spline: derivatives are means of the control points of
// derivatives. Convexity is that the slopes between control points grow, at kinks as well.
struct ShapeWishes {
    static constexpr int rising = 1, falling = 2, convex = 4, concave = 8;
    std::vector<int> along;           // [axes][dim] sums of these, or empty
    std::vector<double> lower, upper; // [dim] or empty, may be infinite

    [[nodiscard]] bool empty() const noexcept { return along.empty() && lower.empty() && upper.empty(); }
};

// Throws Status::rule for a shape that only a constant or a line has, Status::order for a convex axis of degree 0,
// Status::multiplicity for one that may jump at a knot, Status::contradiction for bounds that cross.
void check_shape(const std::vector<KnotVectorPtr> &axes, int dim, const ShapeWishes &wishes);

// How many layers of each axis the inequalities reach beyond one, where that is more than its degree.
Index shape_reach(const std::vector<KnotVectorPtr> &axes, const ShapeWishes &wishes);

// One coordinate of a spline with the distinct layers of the axes.
class CoordinateShape {
public:
    CoordinateShape(const std::vector<KnotVectorPtr> &axes, int dim, const ShapeWishes &wishes,
                    int coordinate);

    [[nodiscard]] bool empty() const noexcept;
    // The inequalities for control points, those of convexity with something to spare, without bounds beyond a limit.
    [[nodiscard]] std::vector<LinearRow> rows(double margin, double limit) const;
    // Puts in order what rounding has disturbed of rising, falling and bounds.
    void settle(std::vector<double> &points) const;
    // Proven, for these very numbers.
    [[nodiscard]] bool holds(const std::vector<double> &points) const;

private:
    // Calls visit(index of the first layer, axis) for each run of `layers` ones along an axis.
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
