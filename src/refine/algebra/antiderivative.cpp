// SPDX-License-Identifier: MIT
#include "refine/algebra/antiderivative.h"

#include "base/checked.h"
#include "base/representable.h"
#include "basis/bspline.h"
#include "numeric/sum.h"
#include "refine/knots/axis_table.h"
#include "spline/axis_view.h"

namespace nrb::refine {

namespace {

KnotVectorPtr integrated(const KnotVector &axis) {
    std::vector<double> knots;
    knots.reserve(axis.knots().size() + 2);
    knots.push_back(axis.knots().front());
    knots.insert(knots.end(), axis.knots().begin(), axis.knots().end());
    knots.push_back(axis.knots().back());
    return std::make_shared<const KnotVector>(axis.degree() + 1, std::move(knots));
}

// How much each step S_i between the layers contributes to the integral from the start of the knot vector to
// the start of the domain. Coefficient i is the sum of the basis functions above step i, at the start of the
// domain. The first layer is minus this integral, so that the antiderivative vanishes there.
std::vector<double> start_coefficients(const KnotVector &axis) {
    const int q = axis.degree();
    const int64_t span = axis.spans().find(axis.domain().lower, false);
    double values[max_basis];
    basis_values(axis.knots().data(), q, span, axis.domain().lower, values);
    std::vector<double> coefficients(static_cast<size_t>(span), 1.0);
    double above = 0;
    for (int j = q; j > 0; --j) { // the sum of the functions above step span - q + j - 1
        above += values[j];
        coefficients[static_cast<size_t>(span - q + j - 1)] = above;
    }
    return coefficients;
}

// Integrates one strand of the net: values that are `stride` apart, one for each layer.
class Integral {
public:
    explicit Integral(const KnotVector &old)
        : made_(integrated(old)), coefficients_(start_coefficients(*made_)) {
        for (int64_t i = 0; i < old.count(); ++i) {
            lengths_.push_back((old[i + old.degree() + 1] - old[i]) / (old.degree() + 1));
        }
    }

    [[nodiscard]] const KnotVectorPtr &axis() const noexcept { return made_; }

    void run(const double *points, int64_t stride, double *out) const {
        CompensatedSum sum;
        for (size_t i = 0; i < coefficients_.size(); ++i) {
            if (coefficients_[i] != 0) {
                sum.add(-coefficients_[i] * (lengths_[i] * points[static_cast<int64_t>(i) * stride]));
            }
        }
        *out = sum.value();
        for (const double length : lengths_) {
            sum.add(length * *points);
            points += stride;
            *(out += stride) = sum.value();
        }
    }

private:
    KnotVectorPtr made_;
    std::vector<double> coefficients_;
    std::vector<double> lengths_;
};

} // namespace

SplinePtr antiderivative(const Spline &spline, int axis) {
    if (spline.rational()) {
        fail(Status::rational, "g is rational: its integral is no spline");
    }
    if (spline.axis(axis).degree() == max_degree) {
        fail(Status::degree, "degree %d of axis %d, raised by 1, would exceed the limit of %d",
             spline.axis(axis).degree(), axis, max_degree);
    }
    const Integral integral(spline.axis(axis));
    const AxisView view = axis_view(spline, axis, spline.dim());
    std::vector<double> points(
        static_cast<size_t>(checked_product(view.outer * view.inner, view.count + 1, "points")));
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t i = 0; i < view.inner; ++i) {
            integral.run(spline.points().data() + o * view.count * view.inner + i, view.inner,
                         points.data() + o * (view.count + 1) * view.inner + i);
        }
    }
    require_representable(points, "control points of the integral");
    return make_result(with_axis(spline, axis, integral.axis()), spline.dim(), Form::polynomial,
                       std::move(points));
}

} // namespace nrb::refine
