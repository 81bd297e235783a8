// SPDX-License-Identifier: MIT
#include "build/make_shape.h"

#include "base/representable.h"

#include <algorithm>
#include <utility>

namespace nrb::build {

SplinePtr make_shape(Spline::Axes axes, int dim, std::vector<double> points, std::vector<double> weights) {
    require_representable(points, "the control points of the shape");
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 1; })) {
        return make_result(std::move(axes), dim, Form::polynomial, std::move(points));
    }
    return make_result(std::move(axes), dim, Form::rational, std::move(points), std::move(weights));
}

} // namespace nrb::build
