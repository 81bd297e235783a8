// SPDX-License-Identifier: MIT
#include "build/coons/face_net.h"

#include "base/checked.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "build/coons/corner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::build {

std::vector<double> FaceNet::layer(int axis, bool upper) const {
    const size_t end = upper ? count(axis) - 1 : 0;
    std::vector<double> result;
    result.reserve(count(1 - axis) * static_cast<size_t>(dim));
    for (size_t i = 0; i < count(1 - axis); ++i) {
        const double *from = axis == 0 ? point(end, i) : point(i, end);
        result.insert(result.end(), from, from + dim);
    }
    return result;
}

namespace {

SplinePtr function_of(const KnotVectorPtr &axis, int dim, std::vector<double> points) {
    return std::make_shared<const Spline>(Spline::Axes{axis}, dim, Form::polynomial, std::move(points),
                                          std::vector<double>());
}

// The numerators over both axes, and the factors of the weights along each axis, null where they are
// constant.
struct Separated {
    SplinePtr numerators;
    std::array<SplinePtr, 2> denominators;
};

// The weights along an axis through control point `pivot`.
std::vector<double> weights_through(const Spline &face, int64_t pivot, int axis) {
    const int64_t columns = face.count(1);
    const int64_t first = axis == 0 ? pivot % columns : pivot / columns * columns;
    std::vector<double> weights;
    for (int64_t i = 0; i < face.count(axis); ++i) {
        weights.push_back(face.weight(first + i * (axis == 0 ? columns : 1)));
    }
    return weights;
}

int64_t first_with_weight(const Spline &face) noexcept {
    int64_t i = 0;
    while (face.weight(i) == 0) {
        ++i;
    }
    return i;
}

SplinePtr denominator(const KnotVectorPtr &axis, const std::vector<double> &weights) {
    const bool equal = std::ranges::all_of(weights, [&](double w) { return w == weights[0]; });
    return equal ? nullptr : function_of(axis, 1, weights);
}

// The factors of the weights: the weights along each axis through the first control point whose weight is not
// 0, those along axis 0 divided by that weight.
struct WeightFactors {
    std::vector<double> rows;
    std::vector<double> columns;

    explicit WeightFactors(const Spline &face) {
        const int64_t pivot = first_with_weight(face);
        rows = weights_through(face, pivot, 0);
        columns = weights_through(face, pivot, 1);
        std::ranges::for_each(rows, [unit = face.weight(pivot)](double &w) { w /= unit; });
    }
    [[nodiscard]] double weight(int64_t i) const noexcept {
        const auto at = static_cast<size_t>(i);
        return rows[at / columns.size()] * columns[at % columns.size()];
    }
};

// Separates the weights. The numerators are divided by factors that are constant.
Separated separated(const SplinePtr &face) {
    if (!face->rational()) {
        return {face, {}};
    }
    const WeightFactors factors(*face);
    const Separated parts{nullptr,
                          {denominator(face->knot_vectors()[0], factors.rows),
                           denominator(face->knot_vectors()[1], factors.columns)}};
    const double constant = (parts.denominators[0] == nullptr ? factors.rows[0] : 1) *
                            (parts.denominators[1] == nullptr ? factors.columns[0] : 1);
    const bool records = face->form() == Form::homogeneous;
    std::vector<double> points;
    for (int64_t i = 0; i < face->point_count(); ++i) {
        const double *stored = face->points().data() + i * face->stored_width();
        for (int c = 0; c < face->dim(); ++c) {
            points.push_back(records ? stored[c] / constant : factors.weight(i) / constant * stored[c]);
        }
    }
    require_representable(points, "numerators");
    return {std::make_shared<const Spline>(face->knot_vectors(), face->dim(), Form::polynomial,
                                           std::move(points), std::vector<double>()),
            parts.denominators};
}

// The factor divided by its first control point, by which the numerators are divided, too. Throws
// Status::weights_vanish if an end of the factor is 0.
SplinePtr normalized(const SplinePtr &factor, std::vector<double> &numerators, size_t index) {
    if (factor == nullptr) {
        return factor;
    }
    const double first = factor->points().front();
    if (first == 0 || factor->points().back() == 0) {
        fail(Status::weights_vanish, "faces[%zu]: a corner lies at infinity", index);
    }
    std::vector<double> weights(factor->points().begin(), factor->points().end());
    std::ranges::for_each(weights, [first](double &w) { w /= first; });
    std::ranges::for_each(numerators, [first](double &x) { x /= first; });
    require_representable(weights, "denominators");
    require_representable(numerators, "numerators");
    return function_of(factor->knot_vectors()[0], 1, std::move(weights));
}

} // namespace

bool has_separate_weights(const Spline &face) {
    if (!face.rational()) {
        return true;
    }
    const WeightFactors factors(face);
    bool separate = true;
    for (int64_t i = 0; i < face.point_count() && separate; ++i) {
        const double weight = face.weight(i);
        separate = std::abs(weight - factors.weight(i)) <= 8 * eps * std::abs(weight);
    }
    return separate;
}

FaceNet make_face_net(const SplinePtr &face, const std::array<Interval, 2> &domains, size_t index) {
    Separated parts = separated(face);
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<size_t>(k);
        parts.numerators = clamped_over(parts.numerators, k, domains[at]);
        if (parts.denominators[at] != nullptr) {
            parts.denominators[at] = clamped_over(parts.denominators[at], 0, domains[at]);
        }
    }
    FaceNet net{face->dim(), {}, {}, {}};
    net.points.assign(parts.numerators->points().begin(), parts.numerators->points().end());
    for (size_t k = 0; k < 2; ++k) {
        net.axes[k] = parts.numerators->knot_vectors()[k];
        net.denominators[k] = normalized(parts.denominators[k], net.points, index);
    }
    return net;
}

namespace {

// [rows][columns][dim] to [columns][rows][dim].
std::vector<double> transposed(const std::vector<double> &points, size_t rows, size_t columns, size_t dim) {
    std::vector<double> result(points.size());
    for (size_t i = 0; i < rows; ++i) {
        for (size_t j = 0; j < columns; ++j) {
            std::copy_n(points.data() + (i * columns + j) * dim, dim, result.data() + (j * rows + i) * dim);
        }
    }
    return result;
}

} // namespace

Quotient along(const FaceNet &net, int axis) {
    const auto at = static_cast<size_t>(axis), dim = static_cast<size_t>(net.dim);
    const int64_t width = checked_product(static_cast<int64_t>(net.count(1 - axis)), net.dim, "records");
    if (width > std::numeric_limits<int32_t>::max() - 2) {
        fail(Status::overflow, "rows of %lld values exceed what is supported", static_cast<long long>(width));
    }
    return {function_of(net.axes[at], static_cast<int>(width),
                        axis == 0 ? net.points : transposed(net.points, net.count(0), net.count(1), dim)),
            net.denominators[at]};
}

void replace_axis(FaceNet &net, int axis, KnotVectorPtr knots, const std::vector<double> &rows) {
    net.axes[static_cast<size_t>(axis)] = std::move(knots);
    net.points =
        axis == 0 ? rows : transposed(rows, net.count(1), net.count(0), static_cast<size_t>(net.dim));
}

} // namespace nrb::build
