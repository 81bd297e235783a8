// SPDX-License-Identifier: MIT
#include "fit/offset/band.h"

#include "pieces/extraction.h"

namespace nrb::fit {

SplinePtr band_of(const Spline &surface, const std::vector<double> &params) {
    const KnotVector &axis = surface.axis(0);
    const std::vector<int64_t> layers = pieces::first_layers(axis, params);
    const int64_t first = layers.front(), end = layers.back() + axis.degree() + 1,
                  row = surface.point_count() / axis.count();
    const std::span<const double> knots = axis.knots(), points = surface.points();
    const int width = surface.stored_width();
    std::vector<double> weights;
    for (int64_t i = first * row; surface.form() == Form::rational && i < end * row; ++i) {
        weights.push_back(surface.weight(i));
    }
    return make_result(
        {make_knot_vector(axis.degree(), {knots.begin() + first, knots.begin() + end + axis.degree() + 1}),
         surface.knot_vectors()[1]},
        surface.dim(), surface.form(),
        {points.begin() + first * row * width, points.begin() + end * row * width}, std::move(weights));
}

} // namespace nrb::fit
