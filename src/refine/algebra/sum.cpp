// SPDX-License-Identifier: MIT
#include "refine/algebra/sum.h"

#include "base/representable.h"
#include "refine/algebra/product.h"
#include "refine/forms/homogeneous.h"
#include "refine/forms/weights.h"
#include "refine/knots/axis_table.h"

#include <algorithm>

namespace nrb::refine {

namespace {

// Both splines over common axes: the higher of the two degrees, and the knots of both.
struct Common {
    SplinePtr a;
    SplinePtr b;
};

bool same_axis(const KnotVector &a, const KnotVector &b) {
    return a.degree() == b.degree() && a.periodic() == b.periodic() &&
           std::ranges::equal(a.knots(), b.knots());
}

SplinePtr raised(const SplinePtr &spline, int k, const CommonKnots &joint, int member) {
    if (same_axis(spline->axis(k), *joint.axis())) {
        return spline;
    }
    return with_axis(*spline, k, {joint.axis(), joint.raising(member)});
}

Common common(SplinePtr a, SplinePtr b) {
    for (int k = 0; k < a->axes(); ++k) {
        const KnotVector &of_a = a->axis(k), &of_b = b->axis(k);
        const CommonKnots joint(std::max(of_a.degree(), of_b.degree()), {&of_a, &of_b}, 0);
        a = raised(a, k, joint, 0);
        b = raised(b, k, joint, 1);
    }
    return {std::move(a), std::move(b)};
}

// The linear combination of the stored points. If a record ends with its weight, the weight is kept.
SplinePtr combined(const Spline &a, double alpha, const Spline &b, double beta) {
    std::vector<double> points(a.points().begin(), a.points().end());
    const auto width = static_cast<size_t>(a.stored_width()), dim = static_cast<size_t>(a.dim());
    for (size_t i = 0; i < points.size(); ++i) {
        if (i % width < dim) {
            points[i] = alpha * a.points()[i] + beta * b.points()[i];
        }
    }
    require_representable(points, "control points of the sum");
    return make_result(a.knot_vectors(), a.dim(), a.form(), std::move(points),
                       {a.weights().begin(), a.weights().end()});
}

// The sum over the product of the denominators: (alpha A w_b + beta B w_a) / (w_a w_b).
SplinePtr over_product(const Spline &a, double alpha, const Spline &b, double beta) {
    const std::vector<CommonKnots> joint = product_axes(a.knot_vectors(), b.knot_vectors());
    const int dim = a.dim();
    Bilinear form; // component dim of a polynomial spline stands for the constant 1
    for (int c = 0; c < dim; ++c) {
        form.push_back({c, c, dim, alpha});
        form.push_back({c, dim, c, beta});
    }
    form.push_back({dim, dim, dim});
    return from_records(axes_of(joint), dim, std::max(a.form(), b.form()),
                        product_records({a.knot_vectors(), a.records(), a.width()},
                                        {b.knot_vectors(), b.records(), b.width()}, joint, dim + 1, form));
}

} // namespace

SplinePtr sum(const SplinePtr &a, double alpha, const SplinePtr &b, double beta) {
    check_same_domains(a->knot_vectors(), b->knot_vectors());
    if (a->dim() != b->dim()) {
        fail(Status::dimension, "dimension %d of b, expected %d as of a", b->dim(), a->dim());
    }
    if (a->rational() == b->rational()) {
        const Common same = common(a, b);
        if (same_weights(*same.a, *same.b)) {
            return combined(*same.a, alpha, *same.b, beta);
        }
    }
    return over_product(*a, alpha, *b, beta);
}

} // namespace nrb::refine
