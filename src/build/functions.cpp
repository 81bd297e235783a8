#include "build/functions.h"

#include "reduce/compatible.h"
#include "refine/product.h"

#include <algorithm>
#include <array>
#include <utility>

namespace nrb {

SplinePtr polynomial_spline(Spline::Axes axes, int dim, std::vector<double> points) {
    return std::make_shared<const Spline>(std::move(axes), dim, Form::polynomial, std::move(points),
                                          std::vector<double>());
}

bool same_function(const SplinePtr &a, const SplinePtr &b) {
    const std::array<SplinePtr, 2> both = {a, b};
    const Compatible made = make_compatible(both, 0, false);
    return std::ranges::equal(made.splines[0]->points(), made.splines[1]->points());
}

SplinePtr times(const SplinePtr &a, const SplinePtr &factor) {
    return factor == nullptr ? a : a == nullptr ? factor : product(*a, *factor, ProductKind::components);
}

} // namespace nrb
