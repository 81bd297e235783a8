// SPDX-License-Identifier: MIT
// Degree elevation as a table: H. Prautzsch, "Degree elevation of B-spline curves", Computer Aided Geometric
// Design 1 (1984).
#pragma once

#include "basis/knot_vector.h"
#include "spline/layer_table.h"

#include <span>
#include <vector>

namespace nrb::refine {

// An axis of one degree more, and the rows that give its control points from the old ones.
//
// Every knot occurs once more, except that on axes that are not periodic the first and last knots beyond the
// domain are left out where degree + 2 remain. Control point j is the mean, over the degree + 1 knots that
// belong to it, of the old polar form at the others (Ramshaw 1989). These are knots of a refinement of the
// old ones, so that every factor lies in [0, 1]: an entry is accurate to about 4 d eps relative to itself,
// d <= (degree + 1) / 2 + 1 the number of knots that the refinement adds among its arguments, and where the
// knots leave a control point as it was its row is a copy. Throws Status::periodic_knots if the copies of
// knots on a periodic axis are not as often equal as the knots, not_representable. Precondition: degree <
// max_degree. Cost: O(degree^3) for each control point, O(degree) with simple knots up to degree 3.
class Elevation {
public:
    // A knot of the old vector: its first index, and how often it occurs there.
    struct Group {
        double knot;
        int64_t first;
        int multiplicity;
    };

    // The axis must outlive this.
    explicit Elevation(const KnotVector &axis);

    [[nodiscard]] std::vector<double> knots() const;
    // All layers; of a periodic axis those of one period, over the endless sequence of old layers, in which
    // layer i is stored layer i modulo axis.distinct_layers().
    [[nodiscard]] int64_t rows() const noexcept { return rows_; }
    [[nodiscard]] LayerTable rows(int64_t first, int64_t end) const;

private:
    // On a periodic axis also the knots of the periods before and after.
    [[nodiscard]] std::span<const double> old_knots() const noexcept {
        return axis_.periodic() ? std::span<const double>(extended_) : axis_.knots();
    }

    const KnotVector &axis_;
    int64_t lead_; // extended knots before the stored ones
    std::vector<double> extended_;
    std::vector<Group> groups_;
    int64_t first_; // raised knot, the first that is kept
    int64_t end_;
    int64_t rows_;
};

} // namespace nrb::refine
