// Small curves for the tests of this room.
#pragma once

#include "basis/knot_vector.h"
#include "spline/spline.h"

#include <vector>

namespace nrb {

inline SplinePtr curve(int degree, std::vector<double> knots, int dim, std::vector<double> points,
                       bool periodic = false) {
    return make_spline({make_knot_vector(degree, std::move(knots), periodic)}, dim, Form::polynomial,
                       std::move(points));
}

// Over [0, 1].
inline SplinePtr bezier(int dim, std::vector<double> points) {
    const auto count = points.size() / static_cast<size_t>(dim);
    std::vector<double> knots(count, 0);
    knots.insert(knots.end(), count, 1);
    return curve(static_cast<int>(count) - 1, std::move(knots), dim, std::move(points));
}

inline std::vector<double> vector_of(std::span<const double> values) {
    return {values.begin(), values.end()};
}

} // namespace nrb
