// SPDX-License-Identifier: MIT
#include "reduce/simplify.h"

#include "base/finite.h"
#include "base/tolerance.h"
#include "base/watch.h"
#include "reduce/reduce_degree.h"
#include "refine/forms/homogeneous.h"

#include <cmath>

namespace nrb::reduce {

namespace {

// The polynomial spline with the same Cartesian points; null for a polynomial spline, or if a point is not
// finite. Points without influence gain some, wherever they are stored.
SplinePtr without_weights(const Spline &given) {
    if (!given.rational()) {
        return nullptr;
    }
    const Spline &spline = given.effective();
    std::vector<double> points = refine::cartesian_points(spline);
    return all_finite(points)
               ? make_result(spline.knot_vectors(), spline.dim(), Form::polynomial, std::move(points))
               : nullptr;
}

// One degree less; null if the weights do not allow it, or if the degree would become 0.
SplinePtr one_degree_less(const SplinePtr &spline, int axis) {
    return spline->axis(axis).degree() <= 1 ? nullptr : lower_degree_if_valid(spline, axis, 1);
}

// Takes a candidate as the result if it is within the tolerance of the original.
bool accept(bounds::DeviationsFrom &original, const SplinePtr &candidate, double tolerance, Reduced &result) {
    if (candidate == nullptr) {
        return false;
    }
    const bounds::DeviationPieces pieces = original.to(*candidate);
    const double bound = pieces.enclosure(pieces.uppers()).upper;
    if (!std::isfinite(bound) || bound > tolerance) {
        return false;
    }
    result = {candidate, bound};
    return true;
}

// Removes as many knots as the remaining tolerance allows.
Reduced thinned(bounds::DeviationsFrom &original, const Reduced &state, double tolerance) {
    const Phase phase;
    const Reduced fewer = reduce_knots(state.spline, -1, tolerance - state.bound);
    Reduced result = state;
    if (fewer.spline != state.spline && !accept(original, fewer.spline, tolerance, result)) {
        result = {fewer.spline, state.bound + fewer.bound};
    }
    return result;
}

} // namespace

// A lower degree may need more knots than the higher one: it is kept only if it does not need more points.
Reduced simplify(const SplinePtr &spline, double tolerance) {
    check_tolerance(tolerance);
    bounds::DeviationsFrom original(*spline);
    Reduced state{spline, 0};
    accept(original, without_weights(*spline), tolerance, state);
    Reduced best = thinned(original, state, tolerance);
    for (int k = 0; k < spline->axes(); ++k) {
        for (Reduced lower = state; accept(original, one_degree_less(lower.spline, k), tolerance, lower);
             state = lower) {
            Reduced candidate = thinned(original, lower, tolerance);
            if (candidate.spline->point_count() > best.spline->point_count()) {
                break;
            }
            best = std::move(candidate);
        }
    }
    return best;
}

} // namespace nrb::reduce
