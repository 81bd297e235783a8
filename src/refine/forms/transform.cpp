// SPDX-License-Identifier: MIT
#include "refine/forms/transform.h"

#include "base/checked.h"
#include "refine/forms/homogeneous.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::refine {

namespace {

double product(const MatrixView &matrix, int64_t row, const double *x) noexcept {
    const double *entries = matrix.entries + row * matrix.columns;
    return std::inner_product(entries + 1, entries + matrix.columns, x + 1, entries[0] * x[0]);
}

void check_representable(double value, int64_t point, int64_t component) {
    if (!std::isfinite(value)) {
        fail(Status::not_representable, "component %lld of the image of points[%lld] overflows",
             static_cast<long long>(component), static_cast<long long>(point));
    }
}

// The weight of a homogeneous record stays; the translation is multiplied by it.
std::vector<double> affine_image(const Spline &spline, const MatrixView &matrix, const double *translation) {
    const bool homogeneous = spline.form() == Form::homogeneous;
    const int64_t width = matrix.rows + (homogeneous ? 1 : 0);
    const int64_t count = spline.point_count();
    std::vector<double> image(static_cast<size_t>(checked_product(count, width, "points")));
    const double *point = spline.points().data();
    double *target = image.data();
    for (int64_t i = 0; i < count; ++i, point += spline.stored_width(), target += width) {
        const double scale = homogeneous ? point[spline.dim()] : 1;
        for (int64_t c = 0; c < matrix.rows; ++c) {
            const double linear = product(matrix, c, point);
            target[c] = translation == nullptr ? linear : linear + scale * translation[c];
            check_representable(target[c], i, c);
        }
        if (homogeneous) {
            target[matrix.rows] = scale;
        }
    }
    return image;
}

std::vector<double> projective_image(const Spline &spline, const MatrixView &matrix) {
    const std::vector<double> records = homogeneous_points(spline);
    const int64_t count = spline.point_count();
    std::vector<double> image(static_cast<size_t>(checked_product(count, matrix.rows, "points")));
    for (int64_t i = 0; i < count; ++i) {
        for (int64_t c = 0; c < matrix.rows; ++c) {
            double &value = image[static_cast<size_t>(i * matrix.rows + c)];
            value = product(matrix, c, records.data() + i * matrix.columns);
            check_representable(value, i, c);
        }
    }
    return image;
}

// The common sign of all weights, each of which is the last value of its record; 0 if they have no common
// sign.
int sign_of_weights(const std::vector<double> &records, int64_t width) noexcept {
    bool positive = true;
    bool negative = true;
    for (auto i = static_cast<size_t>(width) - 1; i < records.size(); i += static_cast<size_t>(width)) {
        positive = positive && records[i] > 0;
        negative = negative && records[i] < 0;
    }
    return positive ? 1 : negative ? -1 : 0;
}

SplinePtr cartesian(const Spline &spline, const std::vector<double> &records, int64_t width, int sign) {
    const int64_t dim = width - 1;
    std::vector<double> points;
    std::vector<double> weights;
    points.reserve(static_cast<size_t>(spline.point_count() * dim));
    weights.reserve(static_cast<size_t>(spline.point_count()));
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const double *record = records.data() + i * width;
        for (int64_t c = 0; c < dim; ++c) {
            points.push_back(record[c] / record[dim]);
            check_representable(points.back(), i, c);
        }
        weights.push_back(sign * record[dim]);
    }
    return make_result(spline.knot_vectors(), static_cast<int>(dim), Form::rational, std::move(points),
                       std::move(weights));
}

} // namespace

SplinePtr transform(const Spline &spline, const MatrixView &matrix, const double *translation) {
    return make_result(spline.knot_vectors(), static_cast<int>(matrix.rows), spline.form(),
                       affine_image(spline, matrix, translation),
                       {spline.weights().begin(), spline.weights().end()});
}

SplinePtr transform_projective(const Spline &spline, const MatrixView &matrix) {
    std::vector<double> records = projective_image(spline, matrix);
    const int sign = spline.form() == Form::homogeneous ? 0 : sign_of_weights(records, matrix.rows);
    if (sign != 0) {
        return cartesian(spline, records, matrix.rows, sign);
    }
    return make_result(spline.knot_vectors(), static_cast<int>(matrix.rows - 1), Form::homogeneous,
                       std::move(records));
}

} // namespace nrb::refine
