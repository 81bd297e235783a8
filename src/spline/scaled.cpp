#include "spline/scaled.h"

#include <cmath>

namespace nrb {

namespace {

KnotVectorPtr multiplied(const KnotVectorPtr &axis, int exponent) {
    if (exponent == 0) {
        return axis;
    }
    std::vector<double> knots(axis->knots().begin(), axis->knots().end());
    for (double &t : knots) {
        t = std::ldexp(t, exponent);
    }
    return std::make_shared<const KnotVector>(axis->degree(), std::move(knots), axis->periodic());
}

} // namespace

SplinePtr scaled(const Spline &spline, const Powers &powers) {
    Spline::Axes axes;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        axes.push_back(multiplied(spline.knot_vectors()[at], powers.knots[at]));
    }
    std::vector<double> points(spline.points().begin(), spline.points().end());
    const auto width = static_cast<size_t>(spline.stored_width()), dim = static_cast<size_t>(spline.dim());
    for (size_t i = 0; i < points.size(); ++i) {
        points[i] = std::ldexp(points[i], i % width < dim ? powers.coordinates : powers.weights);
    }
    std::vector<double> weights(spline.weights().begin(), spline.weights().end());
    for (double &w : weights) {
        w = std::ldexp(w, powers.weights);
    }
    return std::make_shared<const Spline>(std::move(axes), spline.dim(), spline.form(), std::move(points),
                                          std::move(weights));
}

} // namespace nrb
