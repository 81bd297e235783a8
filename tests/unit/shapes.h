// Small splines for the tests of all rooms.
#pragma once

#include "basis/knot_vector.h"
#include "spline/spline.h"

#include <span>
#include <utility>
#include <vector>

namespace shapes {

inline std::vector<double> vector_of(std::span<const double> values) {
    return {values.begin(), values.end()};
}

// Over [0, 1].
inline nrb::KnotVectorPtr bezier_axis(int degree) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0);
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1);
    return nrb::make_knot_vector(degree, std::move(knots));
}

inline nrb::SplinePtr curve(int degree, std::vector<double> knots, int dim, std::vector<double> points,
                            bool periodic = false) {
    return nrb::make_spline({nrb::make_knot_vector(degree, std::move(knots), periodic)}, dim,
                            nrb::Form::polynomial, std::move(points));
}

inline nrb::SplinePtr bezier(int dim, std::vector<double> points, std::vector<double> weights = {}) {
    const auto count = points.size() / static_cast<size_t>(dim);
    const nrb::Form form = weights.empty() ? nrb::Form::polynomial : nrb::Form::rational;
    return nrb::make_spline({bezier_axis(static_cast<int>(count) - 1)}, dim, form, std::move(points),
                            std::move(weights));
}

} // namespace shapes
