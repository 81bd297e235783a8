// SPDX-License-Identifier: MIT
#include "modify/deform/warp.h"

#include "base/representable.h"
#include "basis/bspline.h"
#include "modify/edit/net_editor.h"
#include "numeric/direction.h"
#include "refine/algebra/polynomial.h"
#include "refine/algebra/sum.h"
#include "refine/periodic/period.h"
#include "spline/axis_view.h"

#include <algorithm>

namespace nrb::modify {

namespace {

// A B-spline as the function of one layer of an axis, and its largest value.
struct Bump {
    KnotVectorPtr axis;
    int64_t layer;
    double peak;
};

std::vector<double> even_knots(Interval range, int degree, int k) {
    std::vector<double> knots;
    for (int j = 0; j <= degree + 1; ++j) {
        const double part = static_cast<double>(j) / (degree + 1);
        knots.push_back(j <= degree / 2 ? range.lower + (range.upper - range.lower) * part
                                        : range.upper - (range.upper - range.lower) * (1 - part));
    }
    knots.back() = range.upper;
    for (size_t j = 1; j < knots.size(); ++j) {
        if (!(knots[j - 1] < knots[j])) {
            fail(Status::knots_merge, "range[%d] = [%s, %s] has too few doubles for %zu knots", k,
                 Number(range.lower).text, Number(range.upper).text, knots.size());
        }
    }
    return knots;
}

// The value of the B-spline over these knots in the middle of its support.
double peak_of(const std::vector<double> &own) {
    const auto degree = static_cast<int64_t>(own.size()) - 2;
    std::vector<double> knots(static_cast<size_t>(degree), own.front());
    knots.insert(knots.end(), own.begin(), own.end());
    knots.insert(knots.end(), static_cast<size_t>(degree), own.back());
    const double middle = own.front() + (own.back() - own.front()) / 2;
    const int64_t span = find_span(static_cast<int>(degree), knots, middle, false);
    double values[max_basis];
    basis_values(knots.data(), static_cast<int>(degree), span, middle, values);
    return values[2 * degree - span];
}

// The bump on a clamped axis over the domain, with the knots of the bump inside.
Bump open_bump(const KnotVector &axis, const std::vector<double> &own) {
    const auto degree = static_cast<int>(own.size()) - 2;
    const double lower = axis.domain().lower, upper = axis.domain().upper;
    std::vector<double> knots(static_cast<size_t>(degree) + 1, lower);
    std::copy_if(own.begin(), own.end(), std::back_inserter(knots),
                 [lower, upper](double t) { return lower < t && t < upper; });
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, upper);
    const auto first = std::upper_bound(knots.begin(), knots.end(), own.front()) - 1;
    const int64_t layer = first - knots.begin();
    return {make_knot_vector(degree, std::move(knots)), layer, peak_of(own)};
}

// The bump on a periodic axis: one period of knots from the lower end of the domain, continued on both sides.
Bump periodic_bump(const KnotVector &axis, const std::vector<double> &own) {
    const size_t degree = own.size() - 2;
    const double lower = axis.domain().lower, upper = axis.domain().upper;
    std::vector<double> knots(degree + 1, lower);
    std::copy_if(own.begin(), own.end(), std::back_inserter(knots),
                 [lower, upper](double t) { return lower < t && t < upper; });
    const size_t period = knots.size() - degree;
    knots.resize(knots.size() + degree + 1, upper);
    refine::continue_knots(knots, degree, degree + period, period);
    const auto first = std::upper_bound(knots.begin(), knots.end(), own.front()) - 1;
    const int64_t layer = (first - knots.begin()) % static_cast<int64_t>(period);
    return {make_knot_vector(static_cast<int>(degree), std::move(knots), true), layer, peak_of(own)};
}

std::vector<double> step_of(const double *direction, int dim, double distance,
                            const std::vector<Bump> &bumps) {
    double scale = distance;
    for (const Bump &bump : bumps) {
        scale /= bump.peak;
    }
    std::vector<double> step = unit_vector(direction, dim);
    std::for_each(step.begin(), step.end(), [scale](double &x) { x *= scale; });
    require_representable(step, "the bump");
    return step;
}

// The product of the bumps times a vector: all control points except one, and its copies, are 0.
SplinePtr bump_spline(const std::vector<Bump> &bumps, const std::vector<double> &step) {
    Spline::Axes axes;
    int64_t point = 0, count = 1;
    for (const Bump &bump : bumps) {
        axes.push_back(bump.axis);
        point = point * bump.axis->count() + bump.layer;
        count *= bump.axis->count();
    }
    const auto dim = static_cast<int>(step.size());
    const SplinePtr zero = refine::polynomial_spline(std::move(axes), dim,
                                                     std::vector<double>(static_cast<size_t>(count * dim)));
    NetEditor editor(*zero);
    editor.move(original_of(*zero, point), step.data(), 1);
    return editor.finish();
}

} // namespace

SplinePtr warp(const SplinePtr &spline, const Part &part, const double *direction, double distance,
               int order) {
    std::vector<Bump> bumps;
    for (int k = 0; k < spline->axes(); ++k) {
        const std::vector<double> own = even_knots(part[static_cast<size_t>(k)], order + 1, k);
        const KnotVector &axis = spline->axis(k);
        bumps.push_back(axis.periodic() ? periodic_bump(axis, own) : open_bump(axis, own));
    }
    const std::vector<double> step = step_of(direction, spline->dim(), distance, bumps);
    return refine::sum(spline, 1, bump_spline(bumps, step), 1);
}

} // namespace nrb::modify
