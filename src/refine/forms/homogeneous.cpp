// SPDX-License-Identifier: MIT
#include "refine/forms/homogeneous.h"

#include "base/checked.h"
#include "base/watch.h"

#include <algorithm>
#include <limits>

namespace nrb::refine {

std::vector<double> homogeneous_points(const Spline &spline) {
    if (spline.form() == Form::homogeneous) {
        return copied_watched(spline.points());
    }
    const int dim = spline.dim();
    const int64_t count = spline.point_count();
    std::vector<double> records;
    grow_watched(records,
                 static_cast<size_t>(checked_product(count, int64_t{dim} + 1, "homogeneous points")));
    const double *point = spline.points().data();
    double *record = records.data();
    for (int64_t i = 0; i < count; ++i, point += dim, record += dim + 1) {
        const double w = spline.weight(i);
        std::transform(point, point + dim, record, [w](double x) { return w * x; });
        record[dim] = w;
    }
    return records;
}

std::vector<double> cartesian_points(const Spline &spline) {
    if (spline.form() != Form::homogeneous) {
        return {spline.points().begin(), spline.points().end()};
    }
    std::vector<double> points;
    points.reserve(static_cast<size_t>(spline.point_count() * spline.dim()));
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        for (int c = 0; c < spline.dim(); ++c) {
            points.push_back(spline.coordinate(i, c));
        }
    }
    return points;
}

SplinePtr make_rational(const SplinePtr &spline) {
    if (spline->rational()) {
        return spline;
    }
    return std::make_shared<const Spline>(
        spline->knot_vectors(), spline->dim(), Form::rational,
        std::vector<double>(spline->points().begin(), spline->points().end()),
        std::vector<double>(static_cast<size_t>(spline->point_count()), 1.0));
}

Form common_form(std::span<const SplinePtr> splines) noexcept {
    Form form = Form::polynomial;
    for (const SplinePtr &spline : splines) {
        form = std::max(form, spline->form());
    }
    return form;
}

SplinePtr in_form(const SplinePtr &spline, Form form) {
    if (form != Form::homogeneous || spline->form() == form) {
        return form == Form::polynomial ? spline : make_rational(spline);
    }
    return make_result(spline->knot_vectors(), spline->dim(), form, homogeneous_points(*spline));
}

SplinePtr to_homogeneous(const Spline &spline) {
    constexpr int limit = std::numeric_limits<int32_t>::max() - 1;
    if (spline.dim() == limit) {
        fail(Status::dimension, "dimension %d of g, expected at most %d", spline.dim(), limit - 1);
    }
    return std::make_shared<const Spline>(spline.knot_vectors(), spline.dim() + 1, Form::polynomial,
                                          homogeneous_points(spline), std::vector<double>());
}

SplinePtr from_homogeneous(const Spline &spline) {
    if (spline.rational()) {
        fail(Status::rational, "g is rational; expected a polynomial spline of homogeneous points");
    }
    if (spline.dim() < 2) {
        fail(Status::dimension, "dimension %d of g, expected at least 2", spline.dim());
    }
    return make_result(spline.knot_vectors(), spline.dim() - 1, Form::homogeneous,
                       {spline.points().begin(), spline.points().end()});
}

} // namespace nrb::refine
