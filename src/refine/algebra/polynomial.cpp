// SPDX-License-Identifier: MIT
#include "refine/algebra/polynomial.h"

#include "refine/algebra/product.h"

#include <utility>

namespace nrb::refine {

SplinePtr polynomial_result(Spline::Axes axes, int dim, std::vector<double> points) {
    return make_result(std::move(axes), dim, Form::polynomial, std::move(points));
}

SplinePtr polynomial_spline(Spline::Axes axes, int dim, std::vector<double> points) {
    return std::make_shared<const Spline>(std::move(axes), dim, Form::polynomial, std::move(points),
                                          std::vector<double>());
}

SplinePtr times(const SplinePtr &a, const SplinePtr &factor) {
    return factor == nullptr ? a : a == nullptr ? factor : product(*a, *factor, ProductKind::components);
}

} // namespace nrb::refine
