#include "reduce/simplify.h"

#include "reduce/reduce_degree.h"
#include "reduce/remove_knot.h"

#include <algorithm>
#include <cmath>

namespace nrb {

namespace {

// The polynomial spline of the Cartesian points; null where there are none, or for a polynomial one.
SplinePtr without_weights(const Spline &spline) {
    const int64_t count = spline.point_count();
    if (!spline.rational()) {
        return nullptr;
    }
    std::vector<double> points;
    for (int64_t i = 0; i < count; ++i) {
        for (int c = 0; c < spline.dim(); ++c) {
            points.push_back(spline.coordinate(i, c));
        }
    }
    if (!std::all_of(points.begin(), points.end(), [](double x) { return std::isfinite(x); })) {
        return nullptr;
    }
    return make_spline(spline.knot_vectors(), spline.dim(), Form::polynomial, std::move(points));
}

// One degree less, null where the weights do not allow it.
SplinePtr one_degree_less(const SplinePtr &spline, int axis) {
    if (spline->axis(axis).degree() == 0) {
        return nullptr;
    }
    try {
        return lower_degree(spline, axis, 1);
    } catch (const Error &error) {
        if (error.status() == NURBS_ERROR_WEIGHT_SIGN || error.status() == NURBS_ERROR_WEIGHTS_VANISH) {
            return nullptr;
        }
        throw;
    }
}

// Puts a candidate in the place of the result if it is within the tolerance of the original.
bool accept(const SplinePtr &original, const SplinePtr &candidate, double tolerance, Reduced &result) {
    if (candidate == nullptr) {
        return false;
    }
    const double bound = deviation(*original, *candidate).upper;
    if (!std::isfinite(bound) || bound > tolerance) {
        return false;
    }
    result = {candidate, bound};
    return true;
}

} // namespace

Reduced simplify(const SplinePtr &spline, double tolerance) {
    check_tolerance(tolerance);
    Reduced result{spline, 0};
    accept(spline, without_weights(*spline), tolerance, result);
    for (int k = 0; k < spline->axes(); ++k) {
        while (accept(spline, one_degree_less(result.spline, k), tolerance, result)) {
        }
    }
    const Reduced thinned = reduce_knots(result.spline, -1, tolerance - result.bound);
    if (thinned.spline != result.spline && !accept(spline, thinned.spline, tolerance, result)) {
        result = {thinned.spline, result.bound + thinned.bound};
    }
    return result;
}

} // namespace nrb
