// SPDX-License-Identifier: MIT
#include "modify/deform/free_form.h"

#include "base/finite.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "bounds/deviation.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"
#include "refine/algebra/derivative.h"
#include "refine/compose/compose.h"
#include "refine/forms/homogeneous.h"
#include "refine/forms/transform.h"

#include <algorithm>
#include <cmath>

namespace nrb::modify {

namespace {

// The box, and its affine map A to the domain of the volume.
class Box {
public:
    Box(const Spline &volume, const double *lower, const double *upper) : lower_(lower), upper_(upper) {
        for (int k = 0; k < volume.axes(); ++k) {
            domains_.push_back(volume.axis(k).domain());
        }
    }

    [[nodiscard]] size_t dim() const noexcept { return domains_.size(); }
    [[nodiscard]] double scale(size_t k) const noexcept {
        return (domains_[k].upper - domains_[k].lower) / (upper_[k] - lower_[k]);
    }
    [[nodiscard]] double lower(size_t k) const noexcept { return lower_[k]; }
    [[nodiscard]] Interval domain(size_t k) const noexcept { return domains_[k]; }
    // Coordinate k of A x, clamped to the domain. Throws if x is outside the box by more than rounding.
    [[nodiscard]] double parameter(size_t k, double x) const {
        const double rounding = 64 * eps * std::max(std::abs(lower_[k]), std::abs(upper_[k]));
        if (x < lower_[k] - rounding || x > upper_[k] + rounding) {
            fail(Status::outside_domain, "coordinate %zu of a point of g is %s, outside [%s, %s], the box", k,
                 Number(x).text, Number(lower_[k]).text, Number(upper_[k]).text);
        }
        const auto [lower, upper] = domains_[k];
        return std::clamp(lower + (x - lower_[k]) * scale(k), lower, upper);
    }

private:
    const double *lower_;
    const double *upper_;
    std::vector<Interval> domains_;
};

// The curve in the parameter space of the volume. It is moved to the corner of the box first, as parameter()
// does: far from the origin the two moves together would cancel.
SplinePtr in_parameters(const Spline &curve, const Box &box) {
    std::vector<double> unit(box.dim() * box.dim(), 0.0), matrix(unit), to_corner, to_domain;
    for (size_t k = 0; k < box.dim(); ++k) {
        unit[k * box.dim() + k] = 1;
        matrix[k * box.dim() + k] = box.scale(k);
        to_corner.push_back(-box.lower(k));
        to_domain.push_back(box.domain(k).lower);
    }
    const auto dim = static_cast<int64_t>(box.dim());
    const SplinePtr moved = refine::transform(curve, {dim, dim, unit.data()}, to_corner.data());
    return refine::transform(*moved, {dim, dim, matrix.data()}, to_domain.data());
}

// The largest control point of the derivative of homogeneous records along an axis, where that of the weight is
// multiplied by the size of the spline.
double largest_slope(const SplinePtr &records, int k, double size) {
    const SplinePtr slopes = refine::polynomial_derivative(records, k, 1);
    const int dim = slopes->dim() - 1;
    double largest = 0;
    for (int64_t i = 0; i < slopes->point_count(); ++i) {
        const double *const slope = slopes->points().data() + i * (dim + 1);
        largest = std::max(largest, norm(slope, dim) + size * std::abs(slope[dim]));
    }
    return largest;
}

double magnitude(Interval range) noexcept {
    return std::max(std::abs(range.lower), std::abs(range.upper));
}

// A bound of the distance by which rounding of the parameters A C(t), which the curve holds, and of t, where
// the curve is cut, moves points of the volume V = B / w. The derivatives of V are (B' - V w') / w.
double rounding_of_parameters(const Spline &volume, const Spline &curve, int degree) {
    const double of_cuts =
        4 * eps * magnitude(curve.axis(0).domain()) * largest_slope(refine::to_homogeneous(curve), 0, 0);
    const SplinePtr records = refine::to_homogeneous(volume);
    const double size = volume.dim() * largest_magnitude(refine::cartesian_points(volume));
    double bound = 0;
    for (int k = 0; k < volume.axes(); ++k) {
        const double of_params = 8 * degree * eps * magnitude(volume.axis(k).domain());
        bound += (of_params + of_cuts) * largest_slope(records, k, size);
    }
    const double least = volume.all_weights().smallest;
    return least > 0 ? bound / least : infinity;
}

// The degree of the exact image of a curve; 0 if it is not to be composed: if the degree would be too high,
// if the curve is rational, or if it moves on a line, on which it may turn back.
int image_degree(const Spline &spline, const Spline &volume) noexcept {
    int degree = 0;
    for (int k = 0; k < volume.axes(); ++k) {
        degree += volume.axis(k).degree();
    }
    degree *= spline.axis(0).degree();
    const bool composed = spline.axes() == 1 && volume.axes() > 1 && !spline.rational();
    return composed && degree <= max_degree ? degree : 0;
}

// Points of the volume at packed parameters, in parts between which a watched call may end.
void evaluate_watched(const Spline &volume, const std::vector<double> &params, std::vector<double> &points) {
    constexpr int64_t part = 1024, work_of_a_point = 200;
    const int64_t dim = volume.dim(), count = std::ssize(params) / dim;
    Steps steps(count / part + 1);
    for (int64_t first = 0; first < count; first += part, steps.next(part * work_of_a_point)) {
        const int64_t size = std::min(part, count - first);
        eval::evaluate_points(volume, {}, 0, {params.data() + first * dim, size, dim, dim, 1},
                              {points.data() + first * dim, size, dim, dim, 1});
    }
}

} // namespace

DeformedShape free_form_deform(const SplinePtr &spline, const SplinePtr &volume, const double *lower,
                               const double *upper, double tolerance) {
    const Box box(*volume, lower, upper);
    const UsualLimit usual(usual_work(spline->point_count() + volume->point_count(), 200000));
    const fit::PointMap map = [&](const std::vector<double> &points, std::vector<double> &images) {
        std::vector<double> params;
        grow_watched(params, points.size());
        constexpr size_t values_between_counts = 1024;
        for (size_t i = 0; i < points.size(); ++i) {
            if (i % values_between_counts == 0) {
                count_work(4 * values_between_counts);
            }
            params[i] = box.parameter(i % box.dim(), points[i]);
        }
        evaluate_watched(*volume, params, images);
    };
    const int degree = image_degree(*spline, *volume);
    fit::Judge judge;
    if (degree > 0) {
        const SplinePtr curve = in_parameters(*spline, box);
        const SplinePtr exact = refine::compose(volume, curve);
        const Spline &active = volume->effective();
        const double rounding = 64 * eps * degree * largest_magnitude(active.points()) +
                                rounding_of_parameters(active, *curve, degree);
        judge = [exact, rounding](const SplinePtr &, const SplinePtr &candidate, fit::Cuts &) {
            return bounds::deviation(*exact, *candidate).upper + rounding;
        };
    }
    fit::FittedImage image = fit::fit_image(spline, map, tolerance, judge);
    return {std::move(image.spline), image.deviation, image.proven};
}

} // namespace nrb::modify
