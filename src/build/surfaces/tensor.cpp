// SPDX-License-Identifier: MIT
#include "build/surfaces/tensor.h"

#include "base/checked.h"
#include "base/representable.h"
#include "refine/forms/homogeneous.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nrb::build {

namespace {

// The operands of a tensor product, and the dimension and form of its net.
struct Outer {
    const Spline &a;
    const Spline &b;
    int dim;
    Form form;

    [[nodiscard]] int width() const noexcept { return form == Form::homogeneous ? dim + 1 : dim; }
    [[nodiscard]] int64_t count() const {
        return checked_product(a.point_count(), b.point_count(), "points");
    }
};

std::vector<double> all_weights(const Spline &spline) {
    return spline.rational() ? std::vector<double>(spline.weights().begin(), spline.weights().end())
                             : std::vector<double>(static_cast<size_t>(spline.point_count()), 1.0);
}

void check_axes(const Spline &a, const Spline &b) {
    if (a.axes() + b.axes() > max_axes) {
        fail(Status::axes, "a has %d axes and b %d, expected at most %d together", a.axes(), b.axes(),
             max_axes);
    }
}

// The control points of the result. form(x, w, y, v, out) computes their coordinates; it is linear in the
// record (x, w) of a and in the record (y, v) of b, where w = v = 1 for Cartesian points. Homogeneous results
// have the weight w v after the coordinates.
template <class CoordinateForm>
std::vector<double> outer_points(const Outer &outer, const CoordinateForm &form) {
    const bool homogeneous = outer.form == Form::homogeneous;
    const std::vector<double> records_a =
                                  homogeneous ? refine::homogeneous_points(outer.a) : std::vector<double>(),
                              records_b =
                                  homogeneous ? refine::homogeneous_points(outer.b) : std::vector<double>();
    const double *x = homogeneous ? records_a.data() : outer.a.points().data();
    const int64_t dim_a = outer.a.dim(), dim_b = outer.b.dim(), more = homogeneous ? 1 : 0;
    std::vector<double> points(static_cast<size_t>(checked_product(outer.count(), outer.width(), "points")));
    double *out = points.data();
    const int64_t count_a = outer.a.point_count(), count_b = outer.b.point_count();
    for (int64_t i = 0; i < count_a; ++i, x += dim_a + more) {
        const double *y = homogeneous ? records_b.data() : outer.b.points().data();
        for (int64_t j = 0; j < count_b; ++j, y += dim_b + more, out += outer.width()) {
            const double w = homogeneous ? x[dim_a] : 1, v = homogeneous ? y[dim_b] : 1;
            form(x, w, y, v, out);
            if (homogeneous) {
                out[outer.dim] = w * v;
            }
        }
    }
    require_representable(points, "control points");
    return points;
}

std::vector<double> outer_weights(const Outer &outer) {
    if (outer.form != Form::rational) {
        return {};
    }
    const std::vector<double> of_a = all_weights(outer.a), of_b = all_weights(outer.b);
    std::vector<double> weights(static_cast<size_t>(outer.count()));
    auto row = weights.begin();
    for (const double w : of_a) {
        row = std::ranges::transform(of_b, row, [w](double v) { return w * v; }).out;
    }
    require_representable(weights, "weights");
    return weights;
}

template <class CoordinateForm>
SplinePtr outer_spline(const Spline &a, const Spline &b, int dim, const CoordinateForm &form) {
    const Outer outer{a, b, dim, std::max(a.form(), b.form())};
    Spline::Axes axes = a.knot_vectors();
    axes.insert(axes.end(), b.knot_vectors().begin(), b.knot_vectors().end());
    return make_result(std::move(axes), dim, outer.form, outer_points(outer, form), outer_weights(outer));
}

void check_plane_curve(const Spline &curve, const char *name) {
    check_kind(curve, 1, name);
    check_dimension(curve, 2, 2, name);
}

} // namespace

SplinePtr tensor_sum(const Spline &a, double alpha, const Spline &b, double beta) {
    check_axes(a, b);
    const int dim = a.dim();
    if (b.dim() != dim) {
        fail(Status::dimension, "dimension %d of b, expected %d as of a", b.dim(), dim);
    }
    return outer_spline(a, b, dim, [=](const double *x, double w, const double *y, double v, double *out) {
        for (int c = 0; c < dim; ++c) {
            out[c] = alpha * (x[c] * v) + beta * (y[c] * w);
        }
    });
}

SplinePtr tensor_product(const Spline &a, const Spline &b) {
    check_axes(a, b);
    const int dim = std::max(a.dim(), b.dim());
    if (a.dim() != b.dim() && a.dim() != 1 && b.dim() != 1) {
        fail(Status::dimension, "dimensions %d of a and %d of b, expected equal ones or 1", a.dim(), b.dim());
    }
    const std::ptrdiff_t step_a = a.dim() == 1 ? 0 : 1, step_b = b.dim() == 1 ? 0 : 1;
    return outer_spline(a, b, dim, [=](const double *x, double, const double *y, double, double *out) {
        for (int c = 0; c < dim; ++c) {
            out[c] = x[c * step_a] * y[c * step_b];
        }
    });
}

SplinePtr swung(const Spline &trajectory, const Spline &profile, double scale) {
    check_plane_curve(trajectory, "trajectory");
    check_plane_curve(profile, "profile");
    if (!std::isfinite(scale) || scale == 0) {
        fail(Status::factor, "scale = %s, expected a finite factor that is not 0", Number(scale).text);
    }
    return outer_spline(trajectory, profile, 3,
                        [=](const double *x, double w, const double *r, double, double *out) {
                            out[0] = scale * (r[0] * x[0]);
                            out[1] = scale * (r[0] * x[1]);
                            out[2] = w * r[1];
                        });
}

} // namespace nrb::build
