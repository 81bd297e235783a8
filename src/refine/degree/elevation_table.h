// SPDX-License-Identifier: MIT
// Degree elevation by one as a table of coefficients: H. Prautzsch, "Degree elevation of B-spline curves",
// Computer Aided Geometric Design 1 (1984).
#pragma once

#include "basis/knot_vector.h"
#include "spline/layer_table.h"

#include <span>
#include <vector>

namespace nrb::refine {

// An axis with its degree raised by one, and the rows that give its control points from the old ones.
//
// Every knot gets one more copy. On an axis that is not periodic, the outermost knots are omitted so that
// degree + 2 knots remain from each end of the domain outwards. Control point j is the mean, over the degree
// + 1 knots that belong to it, of the old polar form at the other knots (Ramshaw 1989). These are knots of a
// refinement of the old vector, so every factor lies in [0, 1]. An entry has a relative error of about 4 d
// eps, where d <= (degree + 1) / 2 + 1 is the number of its arguments that the refinement adds. Where the
// knots leave a control point unchanged, its row is a copy. Throws Status::periodic_knots if knots of a
// periodic axis and their copies have different multiplicities, not_representable. Precondition: degree <
// max_degree. Cost: O(degree^3) for each control point; O(degree) for simple knots up to degree 3.
class Elevation {
public:
    // A distinct old knot: the index of its first copy, and its multiplicity.
    struct Group {
        double knot;
        int64_t first;
        int multiplicity;
    };

    // The axis must outlive this.
    explicit Elevation(const KnotVector &axis);

    [[nodiscard]] std::vector<double> knots() const;
    // The rows of all layers; on a periodic axis those of one period. There the old layers form an endless
    // sequence, in which layer i is stored layer i modulo axis.distinct_layers().
    [[nodiscard]] int64_t rows() const noexcept { return rows_; }
    [[nodiscard]] LayerTable rows(int64_t first, int64_t end) const;

private:
    // The old knots; on a periodic axis also knots of the periods before and after.
    [[nodiscard]] std::span<const double> old_knots() const noexcept {
        return axis_.periodic() ? std::span<const double>(extended_) : axis_.knots();
    }

    const KnotVector &axis_;
    int64_t lead_; // knots before the stored ones
    std::vector<double> extended_;
    std::vector<Group> groups_;
    int64_t first_; // index of the first raised knot kept
    int64_t end_;
    int64_t rows_;
};

} // namespace nrb::refine
