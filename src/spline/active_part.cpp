// SPDX-License-Identifier: MIT
#include "spline/active_part.h"

namespace nrb::inline spline {

namespace {

KnotVectorPtr knots_around(const KnotVector &axis, int64_t span) {
    const int p = axis.degree();
    const auto knots = axis.knots().subspan(static_cast<size_t>(span - p), 2 * static_cast<size_t>(p) + 2);
    return std::make_shared<const KnotVector>(p, std::vector<double>(knots.begin(), knots.end()), false);
}

std::vector<int64_t> active_places(const Spline &spline, const std::array<int64_t, max_axes> &spans) {
    std::vector<int64_t> places{0};
    for (int k = 0; k < spline.axes(); ++k) {
        const int64_t span = spans[static_cast<size_t>(k)];
        std::vector<int64_t> next;
        for (const int64_t base : places) {
            for (int64_t i = span - spline.axis(k).degree(); i <= span; ++i) {
                next.push_back(base * spline.count(k) + i);
            }
        }
        places = std::move(next);
    }
    return places;
}

} // namespace

SplinePtr active_part(const Spline &spline, const std::array<int64_t, max_axes> &spans) {
    Spline::Axes axes;
    for (int k = 0; k < spline.axes(); ++k) {
        axes.push_back(knots_around(spline.axis(k), spans[static_cast<size_t>(k)]));
    }
    const int width = spline.stored_width();
    std::vector<double> points, weights;
    for (const int64_t i : active_places(spline, spans)) {
        const double *record = spline.points().data() + i * width;
        points.insert(points.end(), record, record + width);
        if (spline.form() == Form::rational) {
            weights.push_back(spline.weight(i));
        }
    }
    return std::make_shared<const Spline>(std::move(axes), spline.dim(), spline.form(), std::move(points),
                                          std::move(weights));
}

} // namespace nrb::inline spline
