// SPDX-License-Identifier: MIT
#include "modify/deform/free_form.h"

#include "base/finite.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "bounds/deviation.h"
#include "eval/evaluate.h"
#include "refine/compose/compose.h"
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
    [[nodiscard]] double offset(size_t k) const noexcept { return domains_[k].lower - scale(k) * lower_[k]; }
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

// The curve in the parameter space of the volume.
SplinePtr in_parameters(const Spline &curve, const Box &box) {
    std::vector<double> matrix(box.dim() * box.dim(), 0.0), offset;
    for (size_t k = 0; k < box.dim(); ++k) {
        matrix[k * box.dim() + k] = box.scale(k);
        offset.push_back(box.offset(k));
    }
    const auto dim = static_cast<int64_t>(box.dim());
    return refine::transform(curve, {dim, dim, matrix.data()}, offset.data());
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
        const SplinePtr exact = refine::compose(volume, in_parameters(*spline, box));
        const double rounding = 64 * eps * degree * largest_magnitude(volume->effective().points());
        judge = [exact, rounding](const SplinePtr &, const SplinePtr &candidate, fit::Cuts &) {
            return bounds::deviation(*exact, *candidate).upper + rounding;
        };
    }
    fit::FittedImage image = fit::fit_image(spline, map, tolerance, judge);
    return {std::move(image.spline), image.deviation, image.proven};
}

} // namespace nrb::modify
