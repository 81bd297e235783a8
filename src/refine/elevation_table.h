// Degree elevation as a table: H. Prautzsch, "Degree elevation of B-spline curves", Computer Aided Geometric
// Design 1 (1984).
#pragma once

#include "basis/knot_vector.h"
#include "spline/layer_table.h"

#include <vector>

namespace nrb {

// An axis of one degree more, and the rows that give its control points from the old ones.
struct ElevatedAxis {
    std::vector<double> knots;
    // All layers; of a periodic axis those of one period, over the endless sequence of old layers, in which
    // layer i is stored layer i modulo axis.distinct_layers().
    LayerTable rows;
};

// Every knot occurs once more, except that on axes that are not periodic the first and last knots beyond the
// domain are left out where degree + 2 remain. Control point j is the mean, over the degree + 1 knots that
// belong to it, of the old polar form at the others (Ramshaw 1989). These are knots of a refinement of the
// old ones, so that every factor lies in [0, 1]: an entry is accurate to about 4 d eps relative to itself,
// d <= (degree + 1) / 2 + 1 the number of knots that the refinement adds among its arguments, and where the
// knots leave a control point as it was its row is a copy. Throws NURBS_ERROR_PERIODIC_KNOTS if the copies of
// knots on a periodic axis are not as often equal as the knots, _NOT_REPRESENTABLE. Precondition: degree <
// NURBS_MAX_DEGREE. Cost: O(degree^3) for each control point, O(degree) with simple knots up to degree 3.
ElevatedAxis elevated_axis(const KnotVector &axis);

} // namespace nrb
