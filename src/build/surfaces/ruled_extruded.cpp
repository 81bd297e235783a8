// SPDX-License-Identifier: MIT
#include "build/surfaces/ruled_extruded.h"

#include "base/checked.h"
#include "base/representable.h"
#include "build/placement.h"
#include "reduce/compatible.h"
#include "refine/algebra/sum.h"
#include "refine/forms/homogeneous.h"
#include "refine/forms/parametrization.h"
#include "refine/forms/weights.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <array>

namespace nrb::build {

namespace {

// Alternating records of two arrays.
std::vector<double> interleaved(std::span<const double> a, std::span<const double> b, int64_t width) {
    const auto size = static_cast<size_t>(checked_product(std::ssize(a), 2, "points"));
    std::vector<double> both;
    both.reserve(size + Spline::padding);
    both.resize(size);
    double *out = both.data();
    for (auto x = a.begin(), y = b.begin(); x != a.end(); x += width, y += width) {
        out = std::copy_n(x, width, out);
        out = std::copy_n(y, width, out);
    }
    return both;
}

// A copy of the points, each moved by a vector; homogeneous records are moved by their weight times the
// vector.
std::vector<double> moved_points(const Spline &spline, const double *vector) {
    std::vector<double> points(spline.points().begin(), spline.points().end());
    const int dim = spline.dim(), width = spline.stored_width();
    for (auto record = points.begin(); record != points.end(); record += width) {
        const double weight = width > dim ? record[dim] : 1;
        for (int c = 0; c < dim; ++c) {
            record[c] = std::fma(weight, vector[c], record[c]);
        }
    }
    require_representable(points, "control points moved by the vector");
    return points;
}

SplinePtr ruled_over_product(const SplinePtr &a, SplinePtr b) {
    for (int k = 0; k < a->axes(); ++k) {
        const Interval domain = a->axis(k).domain();
        b = refine::reparametrize(b, k, domain);
    }
    return ruled_homogeneous(refine::sum(a, 1, b, 0), refine::sum(a, 0, b, 1));
}

} // namespace

void check_room_for_axis(const Spline &spline, const char *name) {
    if (spline.axes() == max_axes) {
        fail(Status::axes, "%s has %d axes, expected 1 or 2", name, spline.axes());
    }
}

SplinePtr ruled_homogeneous(const SplinePtr &a, const SplinePtr &b) {
    const std::array<SplinePtr, 2> both = {a, b};
    const Form form = refine::common_form(both);
    const SplinePtr lower = refine::in_form(a, form), upper = refine::in_form(b, form);
    Spline::Axes axes = lower->knot_vectors();
    axes.push_back(refine::bezier_knots(1, std::array<double, 2>{0, 1}));
    return make_result(std::move(axes), lower->dim(), form,
                       interleaved(lower->points(), upper->points(), lower->stored_width()),
                       interleaved(lower->weights(), upper->weights(), 1));
}

namespace {

// Explains a frequent mistake: the direction (0, 0, 1), out of the plane, is read as (0, 0) if g lies in the
// plane.
void check_way(const double *vector, int dim) {
    if (dim < 3 && std::all_of(vector, vector + dim, [](double x) { return x == 0; })) {
        fail(Status::direction,
             "vector is zero in its dim = %d components, expected a direction; nurbs_transform() with a "
             "matrix of 3 x %d lifts g into space",
             dim, dim);
    }
    check_direction(vector, dim, "vector");
}

} // namespace

SplinePtr extrude(const SplinePtr &spline, const double *vector) {
    check_room_for_axis(*spline, "g");
    check_way(vector, spline->dim());
    return ruled_homogeneous(spline, make_result(spline->knot_vectors(), spline->dim(), spline->form(),
                                                 moved_points(*spline, vector),
                                                 {spline->weights().begin(), spline->weights().end()}));
}

SplinePtr ruled(const SplinePtr &a, const SplinePtr &b, bool cartesian) {
    check_room_for_axis(*a, "a");
    if (a->axes() != b->axes()) {
        fail(Status::incompatible, "b has %d axes, expected %d as a has", b->axes(), a->axes());
    }
    if (a->dim() != b->dim()) {
        fail(Status::dimension, "dimension %d of b, expected %d as of a", b->dim(), a->dim());
    }
    // A common factor of the weights makes no difference to Cartesian points.
    const std::array<SplinePtr, 2> both = {cartesian ? refine::normalize_weights(a) : a,
                                           cartesian ? refine::normalize_weights(b) : b};
    const std::vector<SplinePtr> same = reduce::make_compatible(both, 0, true).splines;
    return cartesian && !refine::same_weights(*same[0], *same[1]) ? ruled_over_product(both[0], both[1])
                                                                  : ruled_homogeneous(same[0], same[1]);
}

} // namespace nrb::build
