// SPDX-License-Identifier: MIT
#include "bounds/box.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "eval/evaluate.h"
#include "eval/frames/jet.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::bounds {

namespace {

double rounded_up(double x) noexcept {
    return std::nextafter(x, infinity);
}

// Bounds of the largest value of sign times a coordinate.
pieces::LargestValue face(const pieces::SplinePieces &pieces, int coordinate, double sign, double tolerance) {
    const pieces::PieceSource source = [&](int64_t i, pieces::QuotientPiece &out) {
        pieces.fill(i, coordinate, sign, out);
    };
    return pieces::largest_value(pieces.count(), source, tolerance, pieces::default_budget);
}

// How far an evaluated point may be from the exact one, by the accuracy contract: c eps times the largest
// coordinate of a control point, times a ratio of weights of at most 4.
double evaluation_error(const Spline &spline) {
    if (spline.form() == Form::homogeneous) {
        return 0;
    }
    double factor = 0;
    for (int k = 0; k < spline.axes(); ++k) {
        factor += 4 * eval::accuracy_factor(spline.axis(k).degree());
    }
    return factor * eps * largest_magnitude(spline.effective().points());
}

// At the end of a piece the spline takes its limit from inside that piece.
double value_at(const Spline &spline, const double *direction, const std::array<double, max_axes> &params,
                const std::array<double, max_axes> &place) {
    eval::AxisRules rules{};
    for (int k = 0; k < spline.axes(); ++k) {
        rules[static_cast<size_t>(k)].left = place[static_cast<size_t>(k + max_axes - spline.axes())] == 1;
    }
    std::vector<double> point(static_cast<size_t>(spline.dim()));
    eval::evaluate_points(spline, rules, 0, {params.data(), 1, spline.axes(), spline.axes(), 1},
                          {point.data(), 1, spline.dim(), spline.dim(), 1});
    return dot(direction, point.data(), spline.dim());
}

} // namespace

Box bounding_box(const Spline &spline, const Part &part, double tolerance) {
    const pieces::SplinePieces pieces(spline, part);
    const double pad = evaluation_error(spline);
    Box box;
    for (int c = 0; c < spline.dim(); ++c) {
        const double centre = pieces.centre()[static_cast<size_t>(c)];
        const pieces::Enclosure low = face(pieces, c, -1, tolerance).bounds;
        const pieces::Enclosure high = face(pieces, c, 1, tolerance).bounds;
        box.lower.push_back(-rounded_up(low.upper - centre + pad));
        box.upper.push_back(rounded_up(centre + high.upper + pad));
        const double gap = rounded_up(std::max(low.upper - low.lower, high.upper - high.lower) + pad);
        // the faces were rounded twice
        const double moved = 2 * eps * std::max(std::abs(box.lower.back()), std::abs(box.upper.back()));
        box.gap = std::max(box.gap, std::isnan(gap + moved) ? infinity : rounded_up(gap + 2 * moved));
    }
    return box;
}

ExtremePoint extreme_point(const Spline &spline, const double *direction, const Part &part,
                           double tolerance) {
    const pieces::SplinePieces pieces(spline, part);
    const int dim = spline.dim();
    double largest = 0;
    for (int c = 0; c < dim; ++c) {
        largest = std::max(largest, std::abs(direction[c]));
    }
    // a direction of size about 1, so that only results can overflow
    const int exponent = std::ilogb(largest);
    std::vector<double> unit(direction, direction + dim);
    std::for_each(unit.begin(), unit.end(), [exponent](double &x) { x = std::ldexp(x, -exponent); });
    const double length = norm(unit.data(), dim);
    const pieces::PieceSource source = [&](int64_t i, pieces::QuotientPiece &out) {
        pieces.fill(i, unit.data(), out);
    };
    const pieces::LargestValue found =
        pieces::largest_value(pieces.count(), source, tolerance * length, pieces::default_budget);
    if (found.piece < 0) {
        fail(Status::not_representable,
             "no value is known: the weights cannot be shown to be positive anywhere");
    }
    ExtremePoint point;
    point.params = pieces.parameter(found.piece, found.place);
    const double value = value_at(spline, unit.data(), point.params, found.place);
    const double middle = dot(unit.data(), pieces.centre().data(), dim);
    const double far = norm(pieces.centre().data(), dim);
    const double rounding = eps * ((dim + 2) * length * far + std::abs(found.bounds.upper));
    point.value = std::ldexp(value, exponent);
    point.bound = std::ldexp(std::max(value, rounded_up(middle + found.bounds.upper + rounding)), exponent);
    if (!std::isfinite(point.value)) {
        fail(Status::not_representable, "value: the extreme value overflows");
    }
    return point;
}

double extent(const Spline &spline) noexcept {
    double largest = 0;
    for (int c = 0; c < spline.dim(); ++c) {
        double low = spline.coordinate(0, c), high = low;
        for (int64_t i = 1; i < spline.point_count(); ++i) {
            low = std::min(low, spline.coordinate(i, c));
            high = std::max(high, spline.coordinate(i, c));
        }
        largest = std::max(largest, high - low);
    }
    return largest;
}

} // namespace nrb::bounds
